#pragma once

#include "raylab/geometry/nearest_sphere_hit.h"

#include <span>
#include <vector>

namespace raylab::grading::ray_sphere {

inline constexpr std::size_t inputs = 12;  // origin, direction, t min and max, centre, radius
inline constexpr std::size_t outputs = 2;  // 1 or 0 for hit or none, and its t

struct Arguments {
    RayOf<double> ray;
    SphereOf<double> sphere;
};

inline Arguments arguments(std::span<const double> in) {
    return {{{in[0], in[1], in[2]}, {in[3], in[4], in[5]}, {in[6], in[7]}}, {{in[8], in[9], in[10]}, in[11]}};
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [o, d, range] = given.ray;
    const auto& [c, radius] = given.sphere;
    return {o.x, o.y, o.z, d.x, d.y, d.z, range.min, range.max, c.x, c.y, c.z, radius};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&nearest_sphere_hit) function, std::span<const double> in, std::span<double> out) {
    const auto [ray, sphere] = arguments(in);
    const auto t = function(ray, sphere);
    out[0] = t.has_value();
    out[1] = t.value_or(0);
}

}  // namespace raylab::grading::ray_sphere
