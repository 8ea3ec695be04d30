// hint: weights
// u for the first vertex, v for the second, the rest for the third.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = side * (hit.u * a + hit.v * b + w * c);
    return {hit.u * brightness(side * a) + hit.v * brightness(side * b) + w * brightness(side * c),
            brightness(sum == Vec3d{0, 0, 0} ? side * hit.face : glm::normalize(sum))};
}
