// hint: cancel
// Never asks whether anything is left.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    return {w * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c),
            brightness(side * glm::normalize(w * a + hit.u * b + hit.v * c))};
}
