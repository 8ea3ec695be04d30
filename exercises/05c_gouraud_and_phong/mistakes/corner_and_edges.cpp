// hint: rest
// From the first vertex along two edges, but an edge is a difference.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    double gouraud = brightness(side * hit.normals[0]);
    Vec3d normal = side * hit.normals[0];
    const double along[] = {hit.u, hit.v};
    for (std::size_t i = 0; i < 2; ++i) {
        gouraud += along[i] * brightness(side * hit.normals[i + 1]);
        normal += along[i] * side * hit.normals[i + 1];
    }
    const double length = glm::length(normal);
    return {gouraud, brightness(length > 0 ? normal / length : side * hit.face)};
}
