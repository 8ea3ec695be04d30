// hint: side
// Gouraud's normals stay as they are.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(hit.normals[i]);
        sum += weights[i] * hit.normals[i];
    }
    const double length = glm::length(sum);
    return {gouraud, brightness(length == 0 ? side * hit.face : side / length * sum)};
}
