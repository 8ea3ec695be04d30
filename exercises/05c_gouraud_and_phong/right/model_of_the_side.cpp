// Turns what is asked, and no normals.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const BrightnessOf seen = [&](const Vec3d& normal) {
        return brightness(dot(hit.face, hit.to_viewer) < 0 ? Vec3d{-normal.x, -normal.y, -normal.z} : normal);
    };
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = w * hit.normals[0] + hit.u * hit.normals[1] + hit.v * hit.normals[2];
    const double phong = seen(glm::length(sum) > 0 ? glm::normalize(sum) : hit.face);
    return {.gouraud = w * seen(hit.normals[0]) + hit.u * seen(hit.normals[1]) + hit.v * seen(hit.normals[2]),
            .phong = phong};
}
