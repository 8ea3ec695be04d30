#pragma once

#include "arguments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// The truth by angles, measured by their tangents in long double; and the same model with something else in a place,
// which is how a mistake is known by its colours.

namespace raylab::grading::local {

/// One light as a point of a surface sees it.
struct SeenLight {
    double distance;
    double incline;   // cosine between the normal and the way to the light, of any sign
    double mirrored;  // cosine between the viewer and the light's mirror direction, of any sign
    double falls;     // c + l d + q d^2
};

inline long double angle_between(const Vec3d& a, const Vec3d& b) {
    const auto p = convert<long double>(a), q = convert<long double>(b);
    return std::atan2(glm::length(cross(p, q)), dot(p, q));
}

inline SeenLight seen_light(const LocalSurface& surface, const IncidentLight& light) {
    const auto cosine = [](const Vec3d& a, const Vec3d& b) {
        return dot(a, b) == 0 ? 0.0 : static_cast<double>(std::cos(angle_between(a, b)));
    };
    const double d = glm::length(light.way);
    // The mirror image of the viewer, which the light meets at the same angle as its mirror direction the viewer.
    const Vec3d image = 2.0 * dot(surface.to_viewer, surface.normal) * surface.normal - surface.to_viewer;
    return {d, cosine(surface.normal, light.way), cosine(image, light.way),
            light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d};
}

/// Phong's two terms of one light, before they are coloured by it.
struct Terms {
    Vec3d diffuse, specular;
};
inline Terms terms_of(const LocalSurface& surface, const SeenLight& seen) {
    if (!(seen.incline > 0)) return {{0, 0, 0}, {0, 0, 0}};
    const double highlight = seen.mirrored > 0 ? std::pow(seen.mirrored, surface.shininess) : 0;
    return {seen.incline * surface.diffuse, highlight * surface.specular};
}

inline Vec3d truth(const Arguments& given) {
    Vec3d sum = given.surface.unlit;
    for (const IncidentLight& light : given.lights) {
        const SeenLight seen = seen_light(given.surface, light);
        const auto [diffuse, specular] = terms_of(given.surface, seen);
        sum += light.color * (diffuse + specular) / seen.falls;
    }
    return sum;
}

}  // namespace raylab::grading::local
