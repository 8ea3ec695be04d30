#include "raylab/geometry/intersect.h"
#include "raylab/geometry/surface_position.h"

raylab::Vec3d raylab::normal_at(const Ray& ray, const Candidate& candidate, const Shape& shape, const Affine& placement) {
    return surface_position(ray, {.t = candidate.t, .primitive = {}, .u = candidate.u, .v = candidate.v}, shape, placement).normal;
}
