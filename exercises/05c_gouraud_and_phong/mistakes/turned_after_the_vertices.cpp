// hint: side
// The vertices have been asked already when it looks at the side.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    const double gouraud = w * brightness(a) + hit.u * brightness(b) + hit.v * brightness(c);
    Vec3d normal = w * a + hit.u * b + hit.v * c;
    if (normal == Vec3d{0, 0, 0}) normal = hit.face;
    if (dot(hit.face, hit.to_viewer) < 0) normal = -normal;
    return {gouraud, brightness(glm::normalize(normal))};
}
