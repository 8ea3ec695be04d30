// hint: unit_in_between
// or: great_circle
// First along an edge, made unit there, then to the third vertex.
#include "raylab/tracer/gouraud_and_phong.h"

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const Vec3d a = side * hit.normals[0], b = side * hit.normals[1], c = side * hit.normals[2];
    const double gouraud = (1 - hit.u - hit.v) * brightness(a) + hit.u * brightness(b) + hit.v * brightness(c);
    const auto between = [](const Vec3d& from, const Vec3d& to, double share) {
        const Vec3d mixed = (1 - share) * from + share * to;
        return mixed == Vec3d{0, 0, 0} ? mixed : glm::normalize(mixed);
    };
    const Vec3d edge = between(a, b, hit.v < 1 ? hit.u / (1 - hit.v) : 0.0), normal = between(edge, c, hit.v);
    return {gouraud, brightness(normal == Vec3d{0, 0, 0} ? side * hit.face : normal)};
}
