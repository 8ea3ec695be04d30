// hint: one_term
// The diffuse term alone.
#include "raylab/tracer/local_color.h"

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    Vec3d sum = surface.unlit;
    for (const IncidentLight& light : lights) {
        const double distance = glm::length(light.way);
        const Vec3d to_light = light.way / distance;
        const double incline = dot(surface.normal, to_light);
        if (incline <= 0) continue;
        const double falls =
            light.attenuation.x + light.attenuation.y * distance + light.attenuation.z * distance * distance;
        sum += light.color * (surface.diffuse * incline) / falls;
    }
    return sum;
}
