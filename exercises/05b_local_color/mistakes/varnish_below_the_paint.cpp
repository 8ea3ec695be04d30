// hint: plastic
// Takes diffuse for the colour of the whole surface: the paint filters what the varnish reflects.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [n, v, unlit, paint, varnish, shininess] = surface;
    const Vec3d image = 2.0 * dot(n, v) * n - v;
    Vec3d light_sum(0);
    for (const auto& [way, color, attenuation] : lights) {
        const double d2 = dot(way, way), d = std::sqrt(d2);
        const double nl = dot(n, way) / d, rv = dot(image, way) / d;
        const Vec3d arriving = color / (attenuation.x + attenuation.y * d + attenuation.z * d2);
        if (nl > 0) light_sum += nl * arriving;
        if (nl > 0 && rv > 0) light_sum += std::pow(rv, shininess) * arriving * varnish;
    }
    return unlit + paint * light_sum;
}
