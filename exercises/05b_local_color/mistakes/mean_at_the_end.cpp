// hint: sum_of_lights
// Adds all lights up, and divides what they bring by their number at the end.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    if (lights.empty()) return surface.unlit;
    Vec3d brought(0);
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way), nl = dot(surface.normal, way) / d;
        const double rv = dot(glm::reflect(-way, surface.normal), surface.to_viewer) / d;
        const Vec3d arriving = color / (attenuation.x + d * (attenuation.y + d * attenuation.z));
        if (nl > 0) brought += arriving * surface.diffuse * nl;
        if (nl > 0 && rv > 0) brought += arriving * surface.specular * std::pow(rv, surface.shininess);
    }
    return surface.unlit + brought / static_cast<double>(lights.size());
}
