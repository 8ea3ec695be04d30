// hint: side_of_each
// The mixed normal decides which side is seen.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = w * a + hit.u * b + hit.v * c;
    const bool none = sum == Vec3d{0, 0, 0};
    const double side = dot(none ? hit.face : sum, hit.to_viewer) < 0 ? -1 : 1;
    return {w * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c),
            brightness(none ? side * hit.face : side * glm::normalize(sum))};
}
