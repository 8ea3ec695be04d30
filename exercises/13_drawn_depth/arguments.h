#pragma once

#include "raylab/accelerator/item_buffer/drawn_depth.h"

#include <span>
#include <vector>

namespace raylab::grading::drawing_depth {

inline constexpr std::size_t inputs = 11;  // x, y, depth of each corner; x, y of the place
inline constexpr std::size_t outputs = 2;  // 1 or 0: whether the place is covered; the depth there

struct Arguments {
    std::array<DrawnCorner, 3> corners;
    double x, y;
};

inline Arguments arguments(std::span<const double> in) {
    const auto corner = [&](std::size_t i) { return DrawnCorner{in[3 * i], in[3 * i + 1], in[3 * i + 2]}; };
    return {{corner(0), corner(1), corner(2)}, in[9], in[10]};
}

inline std::vector<double> as_input(const Arguments& given) {
    std::vector<double> in;
    for (const auto& [x, y, depth] : given.corners) in.insert(in.end(), {x, y, depth});
    in.insert(in.end(), {given.x, given.y});
    return in;
}

inline void write_depth(const std::optional<double>& depth, std::span<double> out) {
    out[0] = depth ? 1 : 0;
    out[1] = depth.value_or(0);
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&drawn_depth) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    write_depth(function(given.corners, given.x, given.y), out);
}

}  // namespace raylab::grading::drawing_depth
