// hint: whole_exponent
// The power is a loop of multiplications, of which there is no half one.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const auto& [way, color, attenuation] : lights) {
        const double d = std::sqrt(dot(way, way)), nl = dot(way, surface.normal) / d;
        if (!(nl > 0)) continue;
        const double rv = 2 * nl * dot(surface.normal, surface.to_viewer) - dot(way, surface.to_viewer) / d;
        double highlight = rv > 0 ? 1 : 0;
        for (int i = 1; i <= surface.shininess; ++i) highlight *= rv;
        const Vec3d arriving = color / (attenuation.x + d * (attenuation.y + d * attenuation.z));
        sum += arriving * surface.diffuse * nl + arriving * surface.specular * highlight;
    }
    return sum;
}
