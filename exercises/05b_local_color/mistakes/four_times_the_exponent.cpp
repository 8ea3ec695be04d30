// hint: half_vector
// The half vector, and four times the exponent, which looks nearly alike.
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
        const Vec3d half = glm::normalize(to_light + surface.to_viewer);
        const double cosine = std::max(0.0, dot(half, surface.normal));
        const double highlight = cosine > 0 ? std::pow(cosine, 4 * surface.shininess) : 0.0;
        const double falls =
            light.attenuation.x + light.attenuation.y * distance + light.attenuation.z * distance * distance;
        sum += light.color * (surface.diffuse * incline + surface.specular * highlight) / falls;
    }
    return sum;
}
