// hint: light_is_a_place
// Compares the normal with the light's place, not with the way to it.
#include "raylab/tracer/in_shadow.h"

#include <algorithm>
#include <cmath>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    if (dot(normal, light) <= 0) return true;
    double largest = 0;
    for (int i = 0; i < 3; ++i) largest = std::max({largest, std::abs(point[i]), std::abs(light[i])});
    const Vec3d start = point + normal * (1e-10 * largest);
    const auto t = first_hit(start, light - start);
    return t && *t < 1;
}
