// hint: not_unit
// Divides by N.N, not by its root.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) >= 0 ? 1.0 : -1.0;
    const double weights[] = {1 - hit.u - hit.v, hit.u, hit.v};
    InterpolatedBrightness result{0, 0};
    Vec3d sum{0, 0, 0};
    for (int i = 0; i < 3; ++i) {
        const Vec3d normal = hit.normals[static_cast<std::size_t>(i)] * side;
        result.gouraud += weights[i] * brightness(normal);
        sum = sum + weights[i] * normal;
    }
    const double square = dot(sum, sum);
    result.phong = brightness(square == 0 ? side * hit.face : sum / square);
    return result;
}
