// hint: side_of_each
// Every vertex's normal is turned to the viewer.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const auto facing = [&](const Vec3d& normal) { return dot(normal, hit.to_viewer) < 0 ? -normal : normal; };
    const Vec3d a = facing(hit.normals[0]), b = facing(hit.normals[1]), c = facing(hit.normals[2]);
    const double w = 1 - hit.u - hit.v;
    const Vec3d sum = w * a + hit.u * b + hit.v * c;
    return {w * brightness(a) + hit.u * brightness(b) + hit.v * brightness(c),
            brightness(sum == Vec3d{0, 0, 0} ? facing(hit.face) : glm::normalize(sum))};
}
