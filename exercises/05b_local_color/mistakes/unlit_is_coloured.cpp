// hint: unlit
// The unlit colour is filtered by the diffuse one, as ambient light was before.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [normal, to_viewer, unlit, diffuse, specular, shininess] = surface;
    Vec3d color = unlit * diffuse;
    for (const auto& [way, light, coefficients] : lights) {
        const double d = std::sqrt(dot(way, way)), cosine = dot(normal, way) / d;
        if (!(cosine > 0)) continue;
        const Vec3d arriving = light / (coefficients.x + d * (coefficients.y + d * coefficients.z));
        const double shine = dot(2 * cosine * normal - way / d, to_viewer);
        color += arriving * (cosine * diffuse);
        if (shine > 0) color += arriving * (std::pow(shine, shininess) * specular);
    }
    return color;
}
