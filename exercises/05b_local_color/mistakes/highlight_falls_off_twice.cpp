// hint: attenuation
// The highlight is divided by what the light has been divided by already.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const IncidentLight& light : lights) {
        const double d = glm::length(light.way);
        const Vec3d way = light.way / d;
        const double incline = dot(surface.normal, way);
        if (incline <= 0) continue;
        const double mirrored = std::max(0.0, dot(2 * incline * surface.normal - way, surface.to_viewer));
        const double highlight = mirrored > 0 ? std::pow(mirrored, surface.shininess) : 0;
        const double falls = light.attenuation.x + (light.attenuation.y + light.attenuation.z * d) * d;
        const Vec3d arrives = light.color / falls;
        sum += arrives * (incline * surface.diffuse + highlight / falls * surface.specular);
    }
    return sum;
}
