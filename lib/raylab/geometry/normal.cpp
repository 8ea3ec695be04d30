#include "raylab/geometry/intersect.h"
#include "raylab/geometry/surface_position.h"

raylab::Vec3d raylab::normal_at(const Ray& ray, const Candidate& candidate, const Shape& shape, const Affine& placement) {
    const auto& [t, t_error, u, v, part] = candidate;
    return surface_position(ray, {.t = t, .primitive = {}, .u = u, .v = v, .part = part}, shape, placement).normal;
}
