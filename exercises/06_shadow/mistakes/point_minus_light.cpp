// hint: intersects_itself
// The way in the wrong direction.
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
    const Vec3d from = point + 1e-9 * size_of(point, light) * normal, way = from - light;
    const auto t = first_hit(from, way);
    return t && *t < 1;
}
