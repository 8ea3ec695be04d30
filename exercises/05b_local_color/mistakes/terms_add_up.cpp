// hint: kept_from_the_light_before
// The two terms of a light are added to those of the light before.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit, terms(0);
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way), incline = dot(surface.normal, way) / d;
        if (!(incline > 0)) continue;
        const Vec3d mirrored = 2 * incline * surface.normal - way / d;
        terms += incline * surface.diffuse;
        if (const double cosine = dot(mirrored, surface.to_viewer); cosine > 0)
            terms += std::pow(cosine, surface.shininess) * surface.specular;
        sum += color * terms / (attenuation.x + d * (attenuation.y + d * attenuation.z));
    }
    return sum;
}
