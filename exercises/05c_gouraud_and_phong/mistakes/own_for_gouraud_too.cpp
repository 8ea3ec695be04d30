// hint: cancel_phong_alone
// Where the normals cancel it takes the triangle's own for both.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1, first = 1 - hit.u - hit.v;
    const auto& [a, b, c] = hit.normals;
    const Vec3d mixed = side * (first * a + hit.u * b + hit.v * c);
    const double length = glm::length(mixed);
    const double phong = brightness(length > 1e-8 ? mixed / length : side * hit.face);
    if (length <= 1e-8) return {phong, phong};
    return {first * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c), phong};
}
