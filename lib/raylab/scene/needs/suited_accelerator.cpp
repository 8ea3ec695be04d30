#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/shapes.h"
#include "raylab/scene/moving.h"
#include "raylab/scene/needs.h"

#include <glm/geometric.hpp>

#include <memory>
#include <variant>

namespace raylab {

namespace {

// Up to these numbers, testing the primitives is faster than testing boxes, and testing boxes is faster than traversing
// a tree (seconds of chapter 07's scene and of random spheres, solids and triangles: of 18 to 26 the list of boxes
// takes .81 to .97 of the tree's time, of 48 as much or more).
constexpr std::size_t longest_list = 2, longest_boxed_list = 24;

// Only `bvh` has boxes that move; all others hold what moves over all times. (4 samples a pixel of 2000 spheres that go
// ten times their size: 0.5 s instead of bvh8's 0.7; of a mesh that goes its own size 0.3 instead of 0.7, that goes a
// twentieth 0.23 instead of 0.25, and a two-hundredth 0.22 instead of 0.18.)
std::size_t moving_count(const Scene& scene) {
    std::size_t count = 0;
    for (const auto& object : scene.objects)
        if (motion_of(scene, object)) count += part_count(object.shape);
    return count;
}

// A tree whose planes cut triangles takes .1 to .5 microseconds a triangle more to build. Through hair, whose boxes are
// filled to a hundredth, it saves .5 microseconds a ray, a third of all: one ray a triangle pays for it, and four leave
// no doubt. Through scans, halls and cities (a fifth and more) it saves little: from 10 to 600 rays a triangle on, and
// where any hit will do in halls and cities, never.
constexpr double rays_for_splits = 4, filled_boxes = 0.1;

// Of the lines that hit a triangle's box, the share that hits the triangle, over all triangles of the scene's meshes:
// twice its area over the box's (Cauchy). 1 where there is no triangle.
double filled_share(const Scene& scene) {
    double triangles = 0, boxes = 0;
    for (const auto& object : scene.objects) {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape);
        if (!mesh) continue;
        for (std::size_t face = 0; face < (*mesh)->faces.size(); ++face) {
            const Triangle triangle = (*mesh)->triangle(face);
            const Vec3d a = convert<double>(triangle.a), b = convert<double>(triangle.b) - a,
                        c = convert<double>(triangle.c) - a;
            triangles += glm::length(glm::cross(b, c));
            boxes += surface_area(bounds(triangle));
        }
    }
    return boxes > 0 ? triangles / boxes : 1;
}

}  // namespace

std::string suited_accelerator(const Scene& scene, double rays) {
    const std::size_t count = primitive_count(scene);
    if (count <= longest_list) return "list";
    if (count <= longest_boxed_list) return "boxed_list";
    if (2 * moving_count(scene) > count) return "bvh";
    const bool many = rays >= rays_for_splits * static_cast<double>(count);
    return many && filled_share(scene) < filled_boxes ? "bvh8_splits" : "bvh8";
}

std::string chosen_accelerator(const std::string& name, const Scene& scene, double rays) {
    return name == "auto" ? suited_accelerator(scene, rays) : name;
}

}  // namespace raylab
