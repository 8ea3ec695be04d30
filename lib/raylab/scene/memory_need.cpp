#include "raylab/scene/memory_need.h"

#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/moving.h"

#include <fmt/format.h>

#include <set>

namespace raylab {

namespace {

// Measured as the largest resident set of the program, by one thread and by two, of `bvh8` and of `bvh8_splits`: of two
// million triangles that share vertices (one for two triangles) 89 to 109 bytes a triangle, of a million that share
// none 181 to 188; of 400 000 spheres 551 with what their file needs, of 400 000 moving triangles 412.
constexpr double bytes_a_triangle = 96, bytes_a_vertex = 32;  // of a mesh at rest
constexpr double bytes_a_primitive = 560;                     // of any other kind
// A pixel of the Image takes 12; the rest is the record of the first hit of each pixel, and the bytes of the file.
constexpr double bytes_a_pixel = 24;

// What bvh8 holds: the triangles and vertices of meshes at rest, and other primitives.
struct Held {
    std::size_t triangles = 0, vertices = 0, others = 0;

    void add(const Mesh& mesh) {
        triangles += mesh.faces.size();
        vertices += mesh.vertices.size();
    }
    double bytes() const {
        return bytes_a_triangle * static_cast<double>(triangles) + bytes_a_vertex * static_cast<double>(vertices) +
               bytes_a_primitive * static_cast<double>(others);
    }
};

MemoryNeed need_of(const Held& held, std::size_t objects) {
    return {
        .bytes = held.bytes(),
        .what = "a scene",
        .why = fmt::format("{} triangles and other primitives in {} objects", held.triangles + held.others, objects)};
}

// Meshes at places of their own share a tree, and each place is one primitive more.
Held held_of(const Scene& scene) {
    std::set<const Mesh*> shared;
    Held held;
    for (const Object& object : scene.objects) {
        const Mesh* mesh = as_mesh(object.shape);
        const bool moves = motion_of(scene, object) != nullptr;
        if (!mesh || moves) {
            held.others += part_count(object.shape);
        } else if (object.placement.is_identity()) {
            held.add(*mesh);
        } else {
            if (shared.insert(mesh).second) held.add(*mesh);
            ++held.others;
        }
    }
    return held;
}

}  // namespace

MemoryNeed accelerator_need(const Scene& scene) { return need_of(held_of(scene), scene.objects.size()); }

MemoryNeed accelerator_need(const Mesh& mesh) {
    Held held;
    held.add(mesh);
    return need_of(held, 1);
}

MemoryNeed picture_need(const Scene& scene, ImageSize image) {
    MemoryNeed need = accelerator_need(scene);
    need.bytes += bytes_a_pixel * image.width * image.height;
    need.why += fmt::format(", and {} x {} pixels", image.width, image.height);
    return need;
}

}  // namespace raylab
