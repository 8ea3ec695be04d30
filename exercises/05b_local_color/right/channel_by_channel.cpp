// Channel by channel.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const IncidentLight& light : lights) {
        const double d = std::sqrt(dot(light.way, light.way));
        const double nl = dot(light.way, surface.normal) / d, nv = dot(surface.normal, surface.to_viewer);
        if (!(nl > 0)) continue;
        const double rv = 2 * nl * nv - dot(light.way, surface.to_viewer) / d;  // R = 2 (N.L) N - L
        const double shine = rv > 0 ? std::pow(rv, surface.shininess) : 0;
        const double a = light.attenuation[0] + d * (light.attenuation[1] + d * light.attenuation[2]);
        for (int c = 0; c < 3; ++c)
            sum[c] += light.color[c] * (surface.diffuse[c] * nl + surface.specular[c] * shine) / a;
    }
    return sum;
}
