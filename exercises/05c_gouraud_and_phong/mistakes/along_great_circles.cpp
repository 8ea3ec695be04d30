// hint: great_circle
// Turns the first normal to the second, and that to the third.
#include "raylab/tracer/gouraud_and_phong.h"

#include <algorithm>
#include <cmath>

raylab::InterpolatedBrightness raylab::gouraud_and_phong(const InterpolatedHit& hit, const BrightnessOf& brightness) {
    const double side = dot(hit.face, hit.to_viewer) < 0 ? -1 : 1;
    const auto turned = [](const Vec3d& from, const Vec3d& to, double t) {
        const double angle = std::acos(std::clamp(dot(from, to), -1.0, 1.0));
        if (!(angle > 1e-9 && angle < 3.14)) return from;
        return (std::sin((1 - t) * angle) * from + std::sin(t * angle) * to) / std::sin(angle);
    };
    const auto& [a, b, c] = hit.normals;
    const double w = 1 - hit.u - hit.v;
    const bool none = w * a + hit.u * b + hit.v * c == Vec3d{0, 0, 0};
    const Vec3d normal = turned(turned(a, b, hit.v < 1 ? hit.u / (1 - hit.v) : 0), c, hit.v);
    return {w * brightness(side * a) + hit.u * brightness(side * b) + hit.v * brightness(side * c),
            brightness(side * (none ? hit.face : normal))};
}
