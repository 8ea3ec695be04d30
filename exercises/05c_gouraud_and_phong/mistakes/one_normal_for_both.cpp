// hint: same_twice
// Mixes in a function of its own, which is given normals alone: so the model is never asked at a vertex.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const bool behind = dot(hit.face, hit.to_viewer) < 0;
    const auto mixed_normal = [&] {
        const Vec3d along_u = hit.u * (hit.normals[1] - hit.normals[0]),
                    along_v = hit.v * (hit.normals[2] - hit.normals[0]);
        const Vec3d mixed = hit.normals[0] + along_u + along_v;
        const double length = glm::length(mixed);
        return length > 1e-12 ? mixed / length : hit.face;
    };
    const Vec3d normal = behind ? -mixed_normal() : mixed_normal();
    return {brightness(normal), brightness(normal)};
}
