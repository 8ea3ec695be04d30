// hint: lerp_twice
// Between the first two by u, then to the third by v.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const Vec3d a = side * hit.normals[0], b = side * hit.normals[1], c = side * hit.normals[2];
    const Vec3d edge = a * (1 - hit.u) + b * hit.u;
    const Vec3d sum = edge * (1 - hit.v) + c * hit.v;
    const double on_edge = brightness(a) * (1 - hit.u) + brightness(b) * hit.u;
    return {on_edge * (1 - hit.v) + brightness(c) * hit.v,
            brightness(glm::length(sum) > 0 ? glm::normalize(sum) : side * hit.face)};
}
