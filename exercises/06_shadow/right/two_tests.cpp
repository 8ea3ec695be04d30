// The side, then the way, with t in metres.
#include "raylab/tracer/in_shadow.h"

#include <algorithm>
#include <cmath>

namespace {

double size_of(const raylab::Vec3d& a, const raylab::Vec3d& b) {
    double size = 0;
    for (int i = 0; i < 3; ++i) size = std::max({size, std::abs(a[i]), std::abs(b[i])});
    return size;
}

}  // namespace

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d from = point + 1e-10 * size_of(point, light) * normal;
    const double distance = glm::length(light - from);
    const bool behind = dot(light - point, normal) <= 0;
    if (behind) return true;
    const auto t = first_hit(from, (light - from) / distance);
    return t.value_or(distance) < distance * (1 - 1e-10);
}
