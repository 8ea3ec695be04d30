#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/base/unfinished.h"

std::optional<double> raylab::nearest_sphere_hit(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    throw Unfinished{};  // yours: the smallest t in ray.range on the sphere, or std::nullopt
}
