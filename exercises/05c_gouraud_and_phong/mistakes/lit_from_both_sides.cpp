// hint: brighter_side
// Asks for each normal and its opposite.
#include "raylab/tracer/gouraud_and_phong.h"

#include <algorithm>

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto brighter = [&](const Vec3d& normal) { return std::max(brightness(normal), brightness(-normal)); };
    const auto& [a, b, c] = hit.normals;
    const double first = 1 - hit.u - hit.v;
    const Vec3d mixed = first * a + hit.u * b + hit.v * c;
    const double gouraud = first * brighter(a) + hit.u * brighter(b) + hit.v * brighter(c);
    return {gouraud, brighter(mixed == Vec3d{0, 0, 0} ? hit.face : glm::normalize(mixed))};
}
