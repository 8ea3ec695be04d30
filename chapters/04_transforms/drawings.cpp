#include "drawings.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/sampling/sequence.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace raylab::transforms {

namespace {

std::array<Vec3d, 3> columns_of(const SurfacePoint& point) { return AffineSteps::of(point.object->placement).columns; }

// Carries a normal of the world to object space, by the transpose.
Vec3d normal_in_object_space(const std::array<Vec3d, 3>& c, const Vec3d& normal) {
    return glm::normalize(Vec3d{dot(c[0], normal), dot(c[1], normal), dot(c[2], normal)});
}

// Carries a direction of the world to object space, by the inverse.
Vec3d direction_in_object_space(const std::array<Vec3d, 3>& c, const Vec3d& direction) {
    const Vec3d row_0 = cross(c[1], c[2]), row_1 = cross(c[2], c[0]), row_2 = cross(c[0], c[1]);
    const Vec3d carried{dot(row_0, direction), dot(row_1, direction), dot(row_2, direction)};
    return glm::normalize(carried / dot(c[0], row_0));
}

// The cosine between normal and light.
double cosine(const SurfacePoint& point, const Vec3d& normal, const Vec3d& light, Lit lit) {
    const auto columns = columns_of(point);
    const Vec3d stored = normal_in_object_space(columns, normal);
    if (lit == Lit::in_object_space) return dot(stored, direction_in_object_space(columns, light));
    if (lit == Lit::in_world) return dot(normal, light);
    return dot(glm::normalize(columns[0] * stored.x + columns[1] * stored.y + columns[2] * stored.z), light);
}

}  // namespace

Image draw_lit(const Scene& scene, const CameraFrame& frame, Lit lit, int threads) {
    const auto accelerator = make_accelerator("auto", scene);
    const Vec3d light = glm::normalize(-1.2 * frame.right + 1.6 * frame.up - 0.7 * frame.forward);
    return eye_picture(frame, {.samples = {SamplePattern::jittered, 3, 1}, .threads = threads}, [&](const Ray& ray) {
        Traversal traversal;
        const auto hit = accelerator->closest(ray, traversal);
        if (!hit) return scene.background.color;
        const auto direction = convert<double>(ray.direction);
        const SurfacePoint point = surface_point(scene, ray, *hit);
        const Vec3d normal = facing(point.normal, direction);
        return diffuse_color(scene, point, direction) *
               (0.25 + 0.75 * std::max(0.0, cosine(point, normal, light, lit)));
    });
}

Scene herd(const Scene& scene, const std::shared_ptr<const Mesh>& mesh, int rows) {
    Scene result = scene;
    std::erase_if(result.objects, [](const Object& object) { return !std::holds_alternative<Plane>(object.shape); });
    const Vec3f first = mesh->vertices.at(0);
    Vec3f low = first, high = first;
    for (const auto& vertex : mesh->vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    const Vec3d middle = (convert<double>(low) + convert<double>(high)) * 0.5;
    const double size = glm::length(convert<double>(high - low));
    const auto hide =
        static_cast<std::size_t>(std::ranges::find(scene.materials, "hide", &Material::name) - scene.materials.begin());
    assert(hide < scene.materials.size());  // the chapter's scene contains it
    RandomSequence random(4, 0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < rows; ++column) {
            const double height = random.between(0.7, 1.2);
            const auto stand =
                AffineSteps::translate({-middle.x, -double(low.y), -middle.z})
                    .then(AffineSteps::scale(Vec3d{1, height, 1} * (2.3 / size)))
                    .then(AffineSteps::rotate({0, 1, 0}, random.between(-60, 60)))
                    .then(AffineSteps::translate({1.55 * (column - 0.5 * (rows - 1)), 0, 2.2 - 1.9 * row}));
            result.objects.push_back({.shape = mesh,
                                      .placement = stand.rounded(),
                                      .front = hide,
                                      .back = hide,
                                      .path = fmt::format("herd[{}]/mesh 0", row * rows + column)});
        }
    return result;
}

}  // namespace raylab::transforms
