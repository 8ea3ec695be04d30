// hint: side
// As the normals are given.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = w * a + hit.u * b + hit.v * c;
    return {w * brightness(a) + hit.u * brightness(b) + hit.v * brightness(c),
            brightness(sum == Vec3d{0, 0, 0} ? hit.face : glm::normalize(sum))};
}
