// hint: weights_forgotten
// Adds up what the vertices are bright.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    InterpolatedBrightness result{0, 0};
    Vec3d sum{0, 0, 0};
    for (const Vec3d& normal : hit.normals) {
        result.gouraud += brightness(side * normal);
        sum += side * normal;
    }
    result.phong = brightness(sum == Vec3d{0, 0, 0} ? side * hit.face : glm::normalize(sum));
    return result;
}
