// hint: side
// Takes a triangle for seen from behind where its normal points down.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = hit.face.z < 0 ? -1 : 1, w = 1 - hit.u - hit.v;
    const auto& [a, b, c] = hit.normals;
    const double gouraud = w * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c);
    const Vec3d mixed = side * (w * a + hit.u * b + hit.v * c);
    return {gouraud, brightness(glm::length(mixed) > 0 ? glm::normalize(mixed) : side * hit.face)};
}
