// hint: same_twice
// Gouraud by the mixed normal, too.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    Vec3d normal = (1 - hit.u - hit.v) * hit.normals[0] + hit.u * hit.normals[1] + hit.v * hit.normals[2];
    if (normal == Vec3d{0, 0, 0}) normal = hit.face;
    const double value = brightness(side * glm::normalize(normal));
    return {.gouraud = value, .phong = value};
}
