// hint: not_unit
// Asks for weighted normals, and adds up the answers.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const Vec3d a = side * (1 - hit.u - hit.v) * hit.normals[0], b = side * hit.u * hit.normals[1],
                c = side * hit.v * hit.normals[2];
    const Vec3d sum = a + b + c;
    return {brightness(a) + brightness(b) + brightness(c),
            brightness(sum == Vec3d{0, 0, 0} ? side * hit.face : glm::normalize(sum))};
}
