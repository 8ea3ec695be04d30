// hint: highlight_behind
// The cosine is cut off, and the mirror direction made of what is left.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way);
        const Vec3d l = way / d, arriving = color / dot(attenuation, Vec3d{1, d, d * d});
        const double nl = dot(surface.normal, l);
        const double cut = std::max(0.0, nl);
        const double rv = std::max(0.0, dot(2 * cut * surface.normal - l, surface.to_viewer));
        sum += arriving * (cut * surface.diffuse + std::pow(rv, surface.shininess) * surface.specular);
    }
    return sum;
}
