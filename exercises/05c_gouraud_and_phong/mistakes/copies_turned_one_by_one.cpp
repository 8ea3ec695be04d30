// hint: side_of_each
// In a copy of the hit, each normal that looks away is turned.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    InterpolatedHit seen = hit;
    for (Vec3d& normal : seen.normals)
        if (dot(normal, hit.to_viewer) < 0) normal *= -1.0;
    if (dot(seen.face, hit.to_viewer) < 0) seen.face *= -1.0;
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(seen.normals[i]);
        sum += weights[i] * seen.normals[i];
    }
    const double length = glm::length(sum);
    return {gouraud, brightness(length > 0 ? sum / length : seen.face)};
}
