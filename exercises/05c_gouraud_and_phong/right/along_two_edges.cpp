// From the first vertex along differences.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const bool behind = dot(hit.face, hit.to_viewer) < 0;
    const auto seen = [&](const Vec3d& normal) { return behind ? -normal : normal; };
    const auto at = [&](const auto& a, const auto& b, const auto& c) { return a + hit.u * (b - a) + hit.v * (c - a); };
    const Vec3d a = seen(hit.normals[0]), b = seen(hit.normals[1]), c = seen(hit.normals[2]);
    const Vec3d mixed = at(a, b, c);
    const Vec3d normal = mixed == Vec3d{0, 0, 0} ? seen(hit.face) : glm::normalize(mixed);
    return {at(brightness(a), brightness(b), brightness(c)), brightness(normal)};
}
