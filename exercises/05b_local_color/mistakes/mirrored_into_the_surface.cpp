// hint: another_angle
// reflect(L, N) as shaders have it, for an L that leads away.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [normal, to_viewer, unlit, diffuse, specular, shininess] = surface;
    Vec3d color = unlit;
    for (const auto& [way, light, coefficients] : lights) {
        const double d = std::sqrt(dot(way, way)), cosine = dot(normal, way) / d;
        if (!(cosine > 0)) continue;
        const Vec3d arriving = light / (coefficients.x + d * (coefficients.y + d * coefficients.z));
        const double shine = dot(way / d - 2 * cosine * normal, to_viewer);
        color += arriving * (cosine * diffuse);
        if (shine > 0) color += arriving * (std::pow(shine, shininess) * specular);
    }
    return color;
}
