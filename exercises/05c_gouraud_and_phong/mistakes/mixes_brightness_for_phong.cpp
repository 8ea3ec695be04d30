// hint: same_twice
// Phong by the vertices' brightness, too.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const double a = brightness(side * hit.normals[0]), b = brightness(side * hit.normals[1]),
                 c = brightness(side * hit.normals[2]);
    const double mixed = a + hit.u * (b - a) + hit.v * (c - a);
    return {mixed, mixed};
}
