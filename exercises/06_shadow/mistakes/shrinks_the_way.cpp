// hint: ends_before_the_light
// Ends a tenth before the light.
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
    const Vec3d from = point + 1e-9 * size_of(point, light) * normal, way = light - from;
    if (dot(way, normal) <= 0) return true;
    const auto t = first_hit(from, 0.9 * way);
    return t && *t < 1;
}
