// hint: lerp_twice
// Down the edge to the third vertex by v, then across by u.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto between = [](const auto& from, const auto& to, double t) { return from + t * (to - from); };
    const double a = brightness(side * hit.normals[0]), b = brightness(side * hit.normals[1]),
                 c = brightness(side * hit.normals[2]);
    Vec3d normal = between(between(hit.normals[0], hit.normals[2], hit.v), hit.normals[1], hit.u);
    if (normal == Vec3d{0, 0, 0}) normal = hit.face;
    return {between(between(a, c, hit.v), b, hit.u), brightness(side * glm::normalize(normal))};
}
