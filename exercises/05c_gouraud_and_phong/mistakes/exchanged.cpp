// hint: exchanged
// Phong's number first.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = w * a + hit.u * b + hit.v * c;
    const Vec3d normal = glm::length(sum) > 0 ? glm::normalize(sum) : hit.face;
    return {brightness(side * normal),
            w * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c)};
}
