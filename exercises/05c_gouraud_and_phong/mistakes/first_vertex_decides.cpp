// hint: side_of_each
// The first vertex's normal decides which side is seen.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.normals[0], hit.to_viewer) < 0 ? -1 : 1;
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(side * hit.normals[i]);
        sum += side * weights[i] * hit.normals[i];
    }
    const double seen = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    return {gouraud, brightness(glm::length(sum) == 0 ? seen * hit.face : glm::normalize(sum))};
}
