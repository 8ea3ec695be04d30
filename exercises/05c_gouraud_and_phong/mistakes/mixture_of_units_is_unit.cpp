// hint: not_unit
// Turns a copy of the hit, and thinks that what is mixed of unit vectors is unit.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    InterpolatedHit seen = hit;
    if (dot(hit.face, hit.to_viewer) < 0) {
        for (Vec3d& normal : seen.normals) normal *= -1.0;
        seen.face *= -1.0;
    }
    const auto mix = [&](const auto& a, const auto& b, const auto& c) {
        return (1 - hit.u - hit.v) * a + hit.u * b + hit.v * c;
    };
    const auto& [a, b, c] = seen.normals;
    const Vec3d normal = mix(a, b, c);
    const bool is_none = glm::length(normal) < 1e-10;
    return {mix(brightness(a), brightness(b), brightness(c)), brightness(is_none ? seen.face : normal)};
}
