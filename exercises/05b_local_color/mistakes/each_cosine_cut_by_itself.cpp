// hint: highlight_behind
// Both cosines are cut off at 0, each by itself: the one of the highlight does not know where the light is.
#include "raylab/tracer/local_color.h"

#include <algorithm>
#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto positive = [](const Vec3d& a, const Vec3d& b) { return std::max(0.0, dot(a, b)); };
    Vec3d sum = surface.unlit;
    for (const IncidentLight& light : lights) {
        const double d = glm::length(light.way);
        const Vec3d to_light = light.way / d, mirrored = glm::reflect(-to_light, surface.normal);
        Vec3d terms = positive(surface.normal, to_light) * surface.diffuse;
        terms += std::pow(positive(mirrored, surface.to_viewer), surface.shininess) * surface.specular;
        sum += light.color * terms / dot(light.attenuation, Vec3d{1, d, d * d});
    }
    return sum;
}
