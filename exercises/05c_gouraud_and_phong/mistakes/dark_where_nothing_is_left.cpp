// hint: cancel
// No normal, no light.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = side * (w * a + hit.u * b + hit.v * c);
    const double gouraud = w * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c);
    if (sum == Vec3d{0, 0, 0}) return {gouraud, 0};
    return {gouraud, brightness(glm::normalize(sum))};
}
