// hint: kept_from_the_light_before
// What one light brings is added up in the loop, and the sum of that as well.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit, brought(0);
    for (const auto& [way, color, attenuation] : lights) {
        const double d = glm::length(way), incline = dot(surface.normal, way) / d;
        if (!(incline > 0)) continue;
        const Vec3d mirrored = 2 * incline * surface.normal - way / d;
        const double cosine = dot(mirrored, surface.to_viewer);
        const double highlight = cosine > 0 ? std::pow(cosine, surface.shininess) : 0;
        const double falls = attenuation.x + d * (attenuation.y + d * attenuation.z);
        brought += color * (incline * surface.diffuse + highlight * surface.specular) / falls;
        sum += brought;
    }
    return sum;
}
