// hint: attenuation
// The square of the distance stands for it.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [n, v, unlit, kd, ks, shininess] = surface;
    const Vec3d image = 2.0 * dot(n, v) * n - v;
    Vec3d color = unlit;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto& [way, light, attenuation] = lights[i];
        const double d2 = dot(way, way), d = std::sqrt(d2);
        const double nl = dot(n, way) / d, rv = dot(image, way) / d;
        const double part = 1 / (attenuation.x + attenuation.y * d2 + attenuation.z * d2 * d2);
        const Vec3d arriving = light * part;
        if (nl > 0) color += arriving * kd * nl;
        if (nl > 0 && rv > 0) color += arriving * ks * std::pow(rv, shininess);
    }
    return color;
}
