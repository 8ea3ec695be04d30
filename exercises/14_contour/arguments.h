#pragma once

#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <array>
#include <span>
#include <vector>

namespace raylab::grading::contour {

inline constexpr std::size_t most_vertices = 6;
inline constexpr std::size_t inputs = 7 + 3 * most_vertices;  // point, normal, number of vertices, vertices
inline constexpr std::size_t outputs = 1;                     // the form factor

struct Arguments {
    Vec3d point, normal;
    std::vector<Vec3d> polygon;
};

inline Arguments arguments(std::span<const double> in) {
    Arguments given{{in[0], in[1], in[2]}, {in[3], in[4], in[5]}, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(in[6]); ++i)
        given.polygon.push_back({in[7 + 3 * i], in[8 + 3 * i], in[9 + 3 * i]});
    return given;
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [p, n, polygon] = given;
    std::vector<double> in{p.x, p.y, p.z, n.x, n.y, n.z, static_cast<double>(polygon.size())};
    for (const Vec3d& v : polygon) in.insert(in.end(), {v.x, v.y, v.z});
    in.resize(inputs);
    return in;
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&contour_form_factor) function, std::span<const double> in, std::span<double> out) {
    const auto [point, normal, polygon] = arguments(in);
    out[0] = function(point, normal, polygon);
}

}  // namespace raylab::grading::contour
