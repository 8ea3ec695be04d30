// hint: too_far
// Ignores what is nearer than a thousandth of the way.
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
    const Vec3d way = light - point;
    if (dot(way, normal) <= 0) return true;
    const auto t = first_hit(point + 1e-9 * size_of(point, light) * normal, way);
    return t && *t > 1e-3 && *t < 1 - 1e-9;
}
