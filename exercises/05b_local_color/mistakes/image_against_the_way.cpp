// hint: not_unit
// The normal and the mirrored viewer are unit, the way that both are compared with is not.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [n, v, unlit, kd, ks, shininess] = surface;
    const Vec3d image = 2.0 * dot(n, v) * n - v;
    Vec3d color = unlit;
    for (const auto& [way, light, attenuation] : lights) {
        const double d2 = dot(way, way), nl = dot(n, way), rv = dot(image, way);
        const Vec3d arriving = light / (attenuation.x + attenuation.y * std::sqrt(d2) + attenuation.z * d2);
        if (nl > 0) color += arriving * kd * nl;
        if (nl > 0 && rv > 0) color += arriving * ks * std::pow(rv, shininess);
    }
    return color;
}
