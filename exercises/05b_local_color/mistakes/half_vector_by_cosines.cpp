// hint: half_vector
// N.H without the vector H: |L + V| is the root of 2 + 2 L.V.
#include "raylab/tracer/local_color.h"

#include <cmath>

raylab::Vec3d raylab::local_color(const LocalSurface& surface, std::span<const IncidentLight> lights) {
    const auto& [n, v, unlit, kd, ks, shininess] = surface;
    const double nv = dot(n, v);
    Vec3d matt(0), shiny(0);
    for (const auto& [way, light, attenuation] : lights) {
        const double d2 = dot(way, way), d = std::sqrt(d2);
        const double nl = dot(n, way) / d, lv = dot(way, v) / d;
        if (!(nl > 0)) continue;
        const Vec3d arriving = light / (attenuation.x + attenuation.y * d + attenuation.z * d2);
        const double nh = (nl + nv) / std::sqrt(2 + 2 * lv);
        matt += nl * arriving;
        if (nh > 0) shiny += std::pow(nh, shininess) * arriving;
    }
    return unlit + kd * matt + ks * shiny;
}
