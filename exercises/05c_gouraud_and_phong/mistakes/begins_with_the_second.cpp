// hint: vertex_missing
// Counts the vertices from 1.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d mixed{0, 0, 0};
    for (std::size_t i = 1; i < 3; ++i) {
        gouraud += weights[i] * brightness(side * hit.normals[i]);
        mixed += weights[i] * hit.normals[i];
    }
    const double length = glm::length(mixed);
    return {gouraud, brightness(side * (length > 0 ? mixed / length : hit.face))};
}
