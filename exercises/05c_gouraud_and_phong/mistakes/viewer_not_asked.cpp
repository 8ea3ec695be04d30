// hint: side
// From the first vertex along two edges, by normals that nobody has turned to the viewer.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto along = [&](const auto& first, const auto& second, const auto& third) {
        return first + hit.u * (second - first) + hit.v * (third - first);
    };
    const auto& [a, b, c] = hit.normals;
    const Vec3d mixed = along(a, b, c);
    const double length = glm::length(mixed), gouraud = along(brightness(a), brightness(b), brightness(c));
    if (length < 1e-12) return {gouraud, brightness(hit.face)};
    return {gouraud, brightness(mixed / length)};
}
