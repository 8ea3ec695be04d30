#pragma once

#include "raylab/accelerator/light_buffer/listed_cells.h"

#include <span>
#include <vector>

namespace raylab::grading::listing {

inline constexpr std::size_t most_corners = 5;
inline constexpr std::size_t inputs = 3 + 3 * most_corners;  // face, resolution, how many corners; the corners
inline constexpr std::size_t outputs =
    5;  // 1 or 0: whether something is listed; first and last column, first and last row

struct Arguments {
    std::vector<Vec3d> corners;
    int face, resolution;
};

inline Arguments arguments(std::span<const double> in) {
    Arguments given{{}, static_cast<int>(in[0]), static_cast<int>(in[1])};
    for (std::size_t i = 0; i < static_cast<std::size_t>(in[2]); ++i)
        given.corners.emplace_back(in[3 + 3 * i], in[4 + 3 * i], in[5 + 3 * i]);
    return given;
}

inline std::vector<double> as_input(const Arguments& given) {
    std::vector<double> in{double(given.face), double(given.resolution), double(given.corners.size())};
    for (const Vec3d& corner : given.corners) in.insert(in.end(), {corner.x, corner.y, corner.z});
    in.resize(inputs);
    return in;
}

inline void write_cells(const std::optional<CellRectangle>& cells, std::span<double> out) {
    const auto [left, right, low, high] = cells.value_or(CellRectangle{});
    out[0] = cells ? 1 : 0;
    out[1] = left;
    out[2] = right;
    out[3] = low;
    out[4] = high;
}

/// The rectangle that an answer's numbers stand for.
inline std::optional<CellRectangle> read_cells(std::span<const double> answer) {
    const auto whole = [&](std::size_t i) { return static_cast<int>(answer[i]); };
    if (answer[0] != 1) return std::nullopt;
    return CellRectangle{whole(1), whole(2), whole(3), whole(4)};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&listed_cells) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    write_cells(function(given.corners, given.face, given.resolution), out);
}

}  // namespace raylab::grading::listing
