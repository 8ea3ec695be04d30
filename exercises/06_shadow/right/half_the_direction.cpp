// A direction of half the way: the light is at t = 2.
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
    if (dot(light - point, normal) <= 0) return true;
    const Vec3d from = point + 4e-10 * size_of(point, light) * normal;
    const auto t = first_hit(from, 0.5 * (light - from));
    return t && *t < 2 - 1e-8;
}
