// hint: rest
// The first vertex counts in full.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto& [a, b, c] = hit.normals;
    Vec3d sum = a + hit.u * b + hit.v * c;
    if (sum == Vec3d{0, 0, 0}) sum = hit.face;
    return {brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c),
            brightness(side * glm::normalize(sum))};
}
