// hint: unlit
// A function says how the point looks under one light, its unlit colour included, and the sum of that is returned.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto seen_under = [&](const IncidentLight& light) {
        const double d = glm::length(light.way);
        const Vec3d to_light = light.way / d;
        const double nl = dot(surface.normal, to_light);
        if (nl <= 0) return surface.unlit;
        const double rv = dot(glm::reflect(-to_light, surface.normal), surface.to_viewer);
        const Vec3d terms = nl * surface.diffuse + (rv > 0 ? std::pow(rv, surface.shininess) : 0.0) * surface.specular;
        return surface.unlit + light.color * terms / dot(light.attenuation, Vec3d{1, d, d * d});
    };
    Vec3d sum(0);
    for (const IncidentLight& light : lights) sum += seen_under(light);
    return sum;
}
