// hint: weights_forgotten
// The mean of three, which has no place for the hit's weights.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto mean = [](const auto& a, const auto& b, const auto& c) {
        return (1.0 / 3) * a + (1.0 / 3) * b + (1.0 / 3) * c;
    };
    std::array<Vec3d, 3> normals = hit.normals;
    Vec3d own = hit.face;
    if (dot(hit.face, hit.to_viewer) < 0) {
        for (Vec3d& normal : normals) normal = -normal;
        own = -own;
    }
    const auto& [a, b, c] = normals;
    const Vec3d mixed = mean(a, b, c);
    return {mean(brightness(a), brightness(b), brightness(c)),
            brightness(glm::length(mixed) > 1e-12 ? glm::normalize(mixed) : own)};
}
