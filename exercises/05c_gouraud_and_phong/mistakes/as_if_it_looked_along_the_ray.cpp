// hint: side_turned
// Takes to_viewer for the ray's direction.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const bool from_front = dot(hit.face, -hit.to_viewer) < 0;
    const auto turned = [&](const Vec3d& normal) { return from_front ? -normal : normal; };
    double gouraud = 0;
    Vec3d normal{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const double weight = i == 0 ? 1 - hit.u - hit.v : i == 1 ? hit.u : hit.v;
        gouraud += weight * brightness(turned(hit.normals[i]));
        normal += weight * turned(hit.normals[i]);
    }
    return {gouraud, brightness(normal == Vec3d{0, 0, 0} ? turned(hit.face) : glm::normalize(normal))};
}
