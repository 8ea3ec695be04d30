// hint: attenuation
// or: reciprocal
// c + l d + q d^2 is taken for the factor that a light is dimmed by, and not for what divides it.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [n, v, unlit, kd, ks, shininess] = surface;
    Vec3d matt(0), shiny(0);
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way), nl = dot(n, way) / d;
        const double factor = dot(attenuation, Vec3d{1, d, d * d});
        const double rv = dot(glm::reflect(-way, n), v) / d;
        if (nl <= 0) continue;
        matt += factor * nl * color;
        if (rv > 0) shiny += factor * std::pow(rv, shininess) * color;
    }
    return unlit + kd * matt + ks * shiny;
}
