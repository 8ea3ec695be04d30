// hint: attenuation
// The attenuation may dim and not brighten: cut off at 1, as in old hardware.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const IncidentLight& light : lights) {
        const double distance = glm::length(light.way);
        const Vec3d to_light = light.way / distance;
        const double incline = dot(surface.normal, to_light);
        if (incline <= 0) continue;
        const double mirrored = dot(2 * incline * surface.normal - to_light, surface.to_viewer);
        const double highlight = mirrored > 0 ? std::pow(mirrored, surface.shininess) : 0.0;
        const double dims = std::min(1.0, 1 / (light.attenuation.x + light.attenuation.y * distance +
                                               light.attenuation.z * distance * distance));
        sum += dims * light.color * (incline * surface.diffuse + highlight * surface.specular);
    }
    return sum;
}
