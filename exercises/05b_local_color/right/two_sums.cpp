// A sum of diffuse light and one of highlights, coloured at the end.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d diffuse(0), specular(0);
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way), before = std::max(0.0, dot(surface.normal, way) / d);
        const Vec3d arriving = color / dot(attenuation, Vec3d{1, d, d * d});
        const Vec3d mirrored = 2.0 * dot(surface.normal, way) * surface.normal - way;
        const double cosine = dot(mirrored, surface.to_viewer) / d;
        diffuse += arriving * before;
        if (before > 0 && cosine > 0) specular += arriving * std::pow(cosine, surface.shininess);
    }
    return surface.unlit + surface.diffuse * diffuse + surface.specular * specular;
}
