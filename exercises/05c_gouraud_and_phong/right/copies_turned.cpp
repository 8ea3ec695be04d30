// Turns a copy of the hit.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    InterpolatedHit seen = hit;
    if (glm::dot(seen.face, glm::normalize(seen.to_viewer)) < 0) {
        for (Vec3d& normal : seen.normals) normal *= -1.0;
        seen.face *= -1.0;
    }
    seen.normals[0] *= 1 - seen.u - seen.v;
    seen.normals[1] *= seen.u;
    seen.normals[2] *= seen.v;
    Vec3d sum = seen.normals[0] + seen.normals[1] + seen.normals[2];
    double gouraud = 0;
    for (const Vec3d& weighted : seen.normals) {
        const double weight = glm::length(weighted);
        if (weight > 0) gouraud += weight * brightness(weighted / weight);
    }
    if (sum == Vec3d{0, 0, 0}) sum = seen.face;
    return {gouraud, brightness(glm::normalize(sum))};
}
