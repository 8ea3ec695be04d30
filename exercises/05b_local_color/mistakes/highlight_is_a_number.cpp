// hint: light_color
// The sum of diffuse light is a colour, and that of the highlights a number: no light's colour is in it.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const Vec3d image = 2.0 * dot(surface.normal, surface.to_viewer) * surface.normal - surface.to_viewer;
    Vec3d matt(0);
    double shiny = 0;
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way), part = 1 / dot(attenuation, Vec3d{1, d, d * d});
        const double nl = dot(surface.normal, way) / d, rv = dot(image, way) / d;
        if (nl > 0) matt += part * nl * color;
        if (nl > 0 && rv > 0) shiny += part * std::pow(rv, surface.shininess);
    }
    return surface.unlit + surface.diffuse * matt + surface.specular * shiny;
}
