// Without vectors, and with a tolerance that is far below any normal that counts.
#include "raylab/tracer/gouraud_and_phong.h"

#include <cmath>

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double toward = hit.face.x * hit.to_viewer.x + hit.face.y * hit.to_viewer.y + hit.face.z * hit.to_viewer.z;
    const double w = 1.0 - (hit.u + hit.v);
    double mixed[3] = {0, 0, 0}, length = 0;
    for (int axis = 0; axis < 3; ++axis) {
        mixed[axis] = w * hit.normals[0][axis] + hit.u * hit.normals[1][axis] + hit.v * hit.normals[2][axis];
        length = std::hypot(length, mixed[axis]);
    }
    Vec3d normal = hit.face;
    if (length > 1e-12) normal = {mixed[0] / length, mixed[1] / length, mixed[2] / length};
    double gouraud = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double weight = i == 0 ? w : i == 1 ? hit.u : hit.v;
        const Vec3d n = hit.normals[i];
        if (weight != 0) gouraud += weight * brightness(toward < 0 ? -n : n);
    }
    return {gouraud, brightness(toward < 0 ? -normal : normal)};
}
