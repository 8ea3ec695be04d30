// hint: cancel
// Coordinate by coordinate, and divided by a length that may be 0.
#include "raylab/tracer/gouraud_and_phong.h"

#include <cmath>

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1, w = 1 - (hit.u + hit.v);
    double mixed[3], square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        mixed[axis] = w * hit.normals[0][axis] + hit.u * hit.normals[1][axis] + hit.v * hit.normals[2][axis];
        square += mixed[axis] * mixed[axis];
    }
    const double scale = side / std::sqrt(square);
    double gouraud = w * brightness(side * hit.normals[0]);
    gouraud += hit.u * brightness(side * hit.normals[1]);
    gouraud += hit.v * brightness(side * hit.normals[2]);
    return {gouraud, brightness({scale * mixed[0], scale * mixed[1], scale * mixed[2]})};
}
