// hint: flat
// Phong by the triangle's own normal.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double w = 1 - hit.u - hit.v;
    return {w * brightness(side * hit.normals[0]) + hit.u * brightness(side * hit.normals[1]) +
                hit.v * brightness(side * hit.normals[2]),
            brightness(side * hit.face)};
}
