#pragma once

#include "raylab/geometry/triangle_hit.h"

#include <span>
#include <vector>

namespace raylab::grading::ray_triangle {

inline constexpr std::size_t inputs = 17;  // origin, direction, t min and max, the three vertices
inline constexpr std::size_t outputs = 4;  // 1 or 0 for hit or none, and its t, u, v

struct Arguments {
    RayOf<double> ray;
    TriangleOf<double> triangle;
};

inline Arguments arguments(std::span<const double> in) {
    return {{{in[0], in[1], in[2]}, {in[3], in[4], in[5]}, {in[6], in[7]}},
            {{in[8], in[9], in[10]}, {in[11], in[12], in[13]}, {in[14], in[15], in[16]}}};
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [o, d, range] = given.ray;
    const auto& [a, b, c] = given.triangle;
    return {o.x, o.y, o.z, d.x, d.y, d.z, range.min, range.max, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&triangle_hit) function, std::span<const double> in, std::span<double> out) {
    const auto [ray, triangle] = arguments(in);
    const auto hit = function(ray, triangle);
    const auto [t, u, v] = hit.value_or(TriangleHit{0, 0, 0});
    out[0] = hit.has_value();
    out[1] = t;
    out[2] = u;
    out[3] = v;
}

}  // namespace raylab::grading::ray_triangle
