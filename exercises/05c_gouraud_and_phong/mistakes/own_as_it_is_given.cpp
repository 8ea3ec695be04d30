// hint: cancel_side
// The same by turned copies.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    std::array<Vec3d, 3> normals = hit.normals;
    if (dot(hit.face, hit.to_viewer) < 0)
        for (Vec3d& normal : normals) normal = -normal;
    const double w = 1 - hit.u - hit.v;
    Vec3d mixed = normals[0] * w + normals[1] * hit.u + normals[2] * hit.v;
    if (glm::length(mixed) == 0)
        mixed = hit.face;
    else
        mixed = mixed / glm::length(mixed);
    return {brightness(normals[0]) * w + brightness(normals[1]) * hit.u + brightness(normals[2]) * hit.v,
            brightness(mixed)};
}
