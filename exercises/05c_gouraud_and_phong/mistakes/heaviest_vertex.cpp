// hint: nearest_vertex
// The vertex with the largest weight.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double w = 1 - hit.u - hit.v;
    std::size_t nearest = 0;
    if (hit.u > w) nearest = 1;
    if (hit.v > w && hit.v > hit.u) nearest = 2;
    const double value = brightness(side * hit.normals[nearest]);
    return {value, value};
}
