// hint: rises_too_little
// In metres, and the step that is taken along the way is added to what is hit after it. A low way hardly rises by it.
#include "raylab/tracer/in_shadow.h"

#include <algorithm>
#include <cmath>

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const double distance = glm::length(light - point);
    const Vec3d to_light = (light - point) / distance;
    if (dot(normal, to_light) <= 0) return true;
    double size = 0;
    for (int i = 0; i < 3; ++i) size = std::max({size, std::abs(point[i]), std::abs(light[i])});
    const double step = 1e-10 * size;
    const auto t = first_hit(point + step * to_light, to_light);
    return t && step + *t < distance * (1 - 1e-10);
}
