// hint: face_for_mixed
// The triangle's own normal where the mixed one looks away.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    Vec3d sum = side * (w * a + hit.u * b + hit.v * c);
    if (!(dot(sum, hit.to_viewer) > 0)) sum = side * hit.face;
    return {w * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c),
            brightness(glm::normalize(sum))};
}
