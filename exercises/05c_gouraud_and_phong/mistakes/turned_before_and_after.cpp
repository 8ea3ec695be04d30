// hint: side
// What is mixed of turned normals is turned once more.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const Vec3d a = side * hit.normals[0], b = side * hit.normals[1], c = side * hit.normals[2];
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = w * a + hit.u * b + hit.v * c;
    const double gouraud = w * brightness(a) + hit.u * brightness(b) + hit.v * brightness(c);
    if (glm::length(sum) == 0) return {gouraud, brightness(side * hit.face)};
    return {gouraud, brightness(side * glm::normalize(sum))};
}
