// From the light to the point: nothing may come before the point itself.
#include "raylab/tracer/in_shadow.h"

bool raylab::in_shadow(const Vec3d& point, const Vec3d& normal, const Vec3d& light, const FirstHit& first_hit) {
    const Vec3d way = point - light;
    if (!(dot(way, normal) < 0)) return true;
    const auto t = first_hit(light, way);
    return t && *t < 1 - 1e-8;
}
