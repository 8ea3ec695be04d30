// hint: face_for_mixed
// The same with a direction that is compared after it was made unit.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const Vec3d to_viewer = glm::normalize(hit.to_viewer);
    const Vec3d face = dot(hit.face, to_viewer) < 0 ? -hit.face : hit.face;
    const double side = dot(hit.face, face);
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    double gouraud = 0;
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(side > 0 ? hit.normals[i] : -hit.normals[i]);
        sum += (side > 0 ? weights[i] : -weights[i]) * hit.normals[i];
    }
    const Vec3d normal = glm::length(sum) > 0 ? glm::normalize(sum) : face;
    return {gouraud, brightness(dot(normal, to_viewer) <= 0 ? face : normal)};
}
