// hint: attenuation
// Makes the way of a copy unit, and measures the copy: every light is 1 far.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [n, v, unlit, kd, ks, shininess] = surface;
    const Vec3d image = 2.0 * dot(n, v) * n - v;
    Vec3d matt(0), shiny(0);
    for (IncidentLight light : lights) {
        light.way = glm::normalize(light.way);
        const double d = glm::length(light.way), falls = dot(light.attenuation, Vec3d{1, d, d * d});
        const double nl = dot(n, light.way), rv = dot(image, light.way);
        if (nl > 0) matt += nl / falls * light.color;
        if (nl > 0 && rv > 0) shiny += std::pow(rv, shininess) / falls * light.color;
    }
    return unlit + kd * matt + ks * shiny;
}
