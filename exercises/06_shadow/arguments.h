#pragma once

#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/tracer/in_shadow.h"

#include <array>
#include <limits>
#include <span>

namespace raylab::grading::shadow {

inline constexpr std::size_t inputs = 26;  // point, normal, light, how far the surface is above the point, four spheres
inline constexpr std::size_t outputs = 1;  // 1: in shadow, 0: lit

struct Arguments {
    Vec3d point, normal, light;
    double above;  // of the surface above the point, along the normal: the effect of rounding
    std::array<SphereOf<double>, 4> spheres;  // radius 0: no sphere
};

inline Arguments arguments(std::span<const double> in) {
    const auto vector = [&](std::size_t i) { return Vec3d{in[i], in[i + 1], in[i + 2]}; };
    Arguments given{vector(0), vector(3), vector(6), in[9], {}};
    for (std::size_t i = 0; i < 4; ++i) given.spheres[i] = {vector(10 + 4 * i), in[13 + 4 * i]};
    return given;
}

/// The scene that the function may query: the spheres, and the plane in which the point lies up to rounding.
inline FirstHit first_hit_of(const Arguments& given) {
    return [given](const Vec3d& origin, const Vec3d& direction) {
        std::optional<double> nearest;
        const auto offer = [&](double t) {
            if (t > 0 && (!nearest || t < *nearest)) nearest = t;
        };
        for (const auto& sphere : given.spheres)
            if (sphere.radius > 0)
                if (const auto t =
                        nearest_sphere_hit({origin, direction, {0, std::numeric_limits<double>::infinity()}}, sphere))
                    offer(*t);
        const double speed = dot(given.normal, direction);
        if (speed != 0) offer((given.above - dot(given.normal, origin - given.point)) / speed);
        return nearest;
    };
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&in_shadow) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    out[0] = function(given.point, given.normal, given.light, first_hit_of(given));
}

}  // namespace raylab::grading::shadow
