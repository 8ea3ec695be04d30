// hint: weights_forgotten
// A third of each.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto& [a, b, c] = hit.normals;
    const Vec3d sum = side * (a + b + c);
    return {(brightness(side * a) + brightness(side * b) + brightness(side * c)) / 3,
            brightness(glm::length(sum) == 0 ? side * hit.face : glm::normalize(sum))};
}
