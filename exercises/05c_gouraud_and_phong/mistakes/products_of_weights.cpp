// hint: lerp_twice
// In one sum, but with the weights of a point in a square: (1 - u) (1 - v), u (1 - v) and v.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double weights[] = {(1 - hit.u) * (1 - hit.v), hit.u * (1 - hit.v), hit.v};
    double gouraud = 0;
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        gouraud += weights[i] * brightness(side * hit.normals[i]);
        sum += weights[i] * hit.normals[i];
    }
    if (dot(sum, sum) == 0) sum = hit.face;
    return {gouraud, brightness(side * glm::normalize(sum))};
}
