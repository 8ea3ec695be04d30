#include "raylab/scene/memory_need.h"

#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/moving.h"

#include <fmt/format.h>

#include <set>

namespace raylab {

namespace {

// Measured as the largest resident set over 2 to 9 million triangles. The worst case is taken: a vector has just grown.
constexpr double bytes_a_primitive = 336;
// A pixel of the Image takes 12; the rest is the record of the first hit of each pixel, and the bytes of the file.
constexpr double bytes_a_pixel = 24;

MemoryNeed need_of(std::size_t primitives, std::size_t objects) {
    return {.bytes = bytes_a_primitive * static_cast<double>(primitives),
            .what = "a scene",
            .why = fmt::format("{} triangles and other primitives in {} objects", primitives, objects)};
}

// Triangles and other primitives as bvh8 holds them: meshes at places of their own share a tree, and each place is one
// primitive more.
std::size_t held_primitives(const Scene& scene) {
    std::set<const Mesh*> shared;
    std::size_t count = 0;
    for (const Object& object : scene.objects) {
        const Mesh* mesh = as_mesh(object.shape);
        const bool shares = mesh && !object.placement.is_identity() && !motion_of(scene, object);
        if (!shares || shared.insert(mesh).second) count += part_count(object.shape);
        if (shares) ++count;
    }
    return count;
}

}  // namespace

MemoryNeed accelerator_need(const Scene& scene) { return need_of(held_primitives(scene), scene.objects.size()); }

MemoryNeed accelerator_need(const Mesh& mesh) { return need_of(mesh.faces.size(), 1); }

MemoryNeed picture_need(const Scene& scene, ImageSize image) {
    MemoryNeed need = accelerator_need(scene);
    need.bytes += bytes_a_pixel * image.width * image.height;
    need.why += fmt::format(", and {} x {} pixels", image.width, image.height);
    return need;
}

}  // namespace raylab
