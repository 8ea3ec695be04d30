// hint: not_clamped
// What arrives of a light is cut off at 1.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way);
        const Vec3d l = way / d, arriving = color / dot(attenuation, Vec3d{1, d, d * d});
        const double nl = dot(surface.normal, l);
        if (nl <= 0) continue;
        const double rv = dot(2 * nl * surface.normal - l, surface.to_viewer);
        const double highlight = rv > 0 ? std::pow(rv, surface.shininess) : 0;
        sum += glm::min(arriving, Vec3d{1, 1, 1}) * (nl * surface.diffuse + highlight * surface.specular);
    }
    return sum;
}
