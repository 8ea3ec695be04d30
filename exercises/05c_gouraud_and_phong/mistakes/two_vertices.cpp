// hint: vertex_missing
// Only the two vertices with weights of their own.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const Vec3d sum = side * (hit.u * hit.normals[1] + hit.v * hit.normals[2]);
    return {hit.u * brightness(side * hit.normals[1]) + hit.v * brightness(side * hit.normals[2]),
            brightness(sum == Vec3d{0, 0, 0} ? side * hit.face : glm::normalize(sum))};
}
