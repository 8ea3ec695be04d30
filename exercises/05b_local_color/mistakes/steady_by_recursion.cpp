// hint: attenuation
// The last light and then all before it, each as bright at any distance.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    if (lights.empty()) return surface.unlit;
    const Vec3d others = local_color(surface, lights.first(lights.size() - 1));
    const Vec3d to_light = glm::normalize(lights.back().way);
    const double nl = dot(surface.normal, to_light);
    if (nl <= 0) return others;
    const double rv = dot(glm::reflect(-to_light, surface.normal), surface.to_viewer);
    const Vec3d terms = nl * surface.diffuse + (rv > 0 ? std::pow(rv, surface.shininess) : 0.0) * surface.specular;
    return others + lights.back().color * terms;
}
