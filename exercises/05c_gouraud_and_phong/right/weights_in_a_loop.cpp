// All three at once.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(side * hit.normals[i]);
        sum += side * weights[i] * hit.normals[i];
    }
    const double square = dot(sum, sum);
    return {gouraud, brightness(square > 0 ? sum / glm::length(sum) : side * hit.face)};
}
