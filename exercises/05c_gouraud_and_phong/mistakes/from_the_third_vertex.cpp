// hint: weights
// From the third vertex along two edges, u to the first and v to the second, as other books count.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const BrightnessOf seen = [&](const Vec3d& normal) {
        return brightness(dot(hit.face, hit.to_viewer) < 0 ? -normal : normal);
    };
    const auto& [a, b, c] = hit.normals;
    const auto at = [&](const auto& first, const auto& second, const auto& third) {
        return third + hit.u * (first - third) + hit.v * (second - third);
    };
    const Vec3d mixed = at(a, b, c);
    return {.gouraud = at(seen(a), seen(b), seen(c)),
            .phong = seen(glm::length(mixed) > 1e-12 ? glm::normalize(mixed) : hit.face)};
}
