// hint: attenuation
// Both coefficients are multiplied by d.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d color = surface.unlit;
    for (const IncidentLight& light : lights) {
        const double d = glm::length(light.way);
        const Vec3d l = light.way / d;
        const double cosine = dot(surface.normal, l);
        if (cosine <= 0) continue;
        const Vec3d mirrored = 2.0 * cosine * surface.normal - l;
        const double toward = dot(mirrored, surface.to_viewer);
        Vec3d shine = cosine * surface.diffuse;
        if (toward > 0) shine += std::pow(toward, surface.shininess) * surface.specular;
        color += light.color * shine / (light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d);
    }
    return color;
}
