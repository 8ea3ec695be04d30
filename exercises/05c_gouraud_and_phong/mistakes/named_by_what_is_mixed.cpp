// hint: exchanged
// Takes Gouraud for the one who mixes normals.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    InterpolatedBrightness result{0, 0};
    Vec3d mixed{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        result.phong += weights[i] * brightness(side * hit.normals[i]);
        mixed += side * weights[i] * hit.normals[i];
    }
    const double length = glm::length(mixed);
    result.gouraud = brightness(length > 0 ? mixed / length : side * hit.face);
    return result;
}
