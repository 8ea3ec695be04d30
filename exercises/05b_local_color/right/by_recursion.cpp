// The last light, and then all before it.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    if (lights.empty()) return surface.unlit;
    const Vec3d others = local_color(surface, lights.first(lights.size() - 1));
    const auto& [way, color, attenuation] = lights.back();
    const double d = glm::length(way);
    const Vec3d l = way / d;
    const double nl = dot(surface.normal, l);
    if (nl <= 0) return others;
    const double rv = dot(glm::reflect(-l, surface.normal), surface.to_viewer);
    const Vec3d terms = nl * surface.diffuse + (rv > 0 ? std::pow(rv, surface.shininess) : 0.0) * surface.specular;
    return others + terms * color / (attenuation.x + attenuation.y * d + attenuation.z * d * d);
}
