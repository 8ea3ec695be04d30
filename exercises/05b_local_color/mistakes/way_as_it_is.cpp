// hint: not_unit
// The way to the light is not made a unit vector.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const IncidentLight& light : lights) {
        const double distance = glm::length(light.way);
        const Vec3d to_light = light.way;
        const double incline = dot(surface.normal, to_light);
        if (incline <= 0) continue;
        const Vec3d mirrored = 2.0 * incline * surface.normal - to_light;
        const double cosine = std::max(0.0, dot(mirrored, surface.to_viewer));
        const double highlight = cosine > 0 ? std::pow(cosine, surface.shininess) : 0.0;
        const double falls =
            light.attenuation.x + light.attenuation.y * distance + light.attenuation.z * distance * distance;
        sum += light.color * (surface.diffuse * incline + surface.specular * highlight) / falls;
    }
    return sum;
}
