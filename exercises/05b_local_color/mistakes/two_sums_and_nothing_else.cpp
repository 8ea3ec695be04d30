// hint: unlit
// Two sums are coloured and added at the end, and the unlit colour is not among them.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d matt(0), shiny(0);
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way), before = std::max(0.0, dot(surface.normal, way) / d);
        const Vec3d arriving = color / dot(attenuation, Vec3d{1, d, d * d});
        matt += arriving * before;
        const double toward = dot(glm::reflect(-way, surface.normal), surface.to_viewer) / d;
        if (before > 0 && toward > 0) shiny += arriving * std::pow(toward, surface.shininess);
    }
    return surface.diffuse * matt + surface.specular * shiny;
}
