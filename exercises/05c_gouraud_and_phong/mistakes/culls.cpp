// hint: seen_from_behind
// Leaves out triangles that are seen from behind.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const bool is_front = dot(hit.face, hit.to_viewer) > 0;
    if (!is_front) return {0, 0};
    const double weights[3] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d mixed{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(hit.normals[i]);
        mixed += weights[i] * hit.normals[i];
    }
    return {gouraud, brightness(mixed == Vec3d{0, 0, 0} ? hit.face : glm::normalize(mixed))};
}
