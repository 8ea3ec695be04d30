// hint: clamped
// What the model says is cut off at 1.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto shown = [&](const Vec3d& normal) {
        const double value = brightness(side * normal);
        return value > 1 ? 1 : value;
    };
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * shown(hit.normals[i]);
        sum += weights[i] * hit.normals[i];
    }
    return {gouraud, shown(glm::length(sum) > 0 ? glm::normalize(sum) : hit.face)};
}
