// hint: not_clamped
// Each channel by itself, and none may leave the function with more than 1.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto channel = [&](int c) {
        double value = surface.unlit[c];
        for (const IncidentLight& light : lights) {
            const double d = std::sqrt(dot(light.way, light.way)), nl = dot(light.way, surface.normal) / d;
            if (!(nl > 0)) continue;
            const double rv = 2 * nl * dot(surface.normal, surface.to_viewer) - dot(light.way, surface.to_viewer) / d;
            const double shine = rv > 0 ? std::pow(rv, surface.shininess) : 0;
            const double falls = light.attenuation[0] + d * (light.attenuation[1] + d * light.attenuation[2]);
            value += light.color[c] * (surface.diffuse[c] * nl + surface.specular[c] * shine) / falls;
        }
        return value > 1 ? 1 : value;
    };
    return {channel(0), channel(1), channel(2)};
}
