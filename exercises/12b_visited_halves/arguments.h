#pragma once

#include "raylab/accelerator/split_tree/visited_halves.h"

#include <span>
#include <vector>

namespace raylab::grading::halves {

inline constexpr std::size_t inputs = 5;   // origin, direction, plane, the range's two ends
inline constexpr std::size_t outputs = 7;  // how many halves; of the first two each: 0 below or 1 above, and its range

struct Arguments {
    double origin, direction, plane;
    Interval<double> range;
};

inline Arguments arguments(std::span<const double> in) { return {in[0], in[1], in[2], {in[3], in[4]}}; }

inline std::vector<double> as_input(const Arguments& given) {
    return {given.origin, given.direction, given.plane, given.range.min, given.range.max};
}

inline void write_halves(const std::vector<VisitedHalf>& visited, std::span<double> out) {
    out[0] = static_cast<double>(visited.size());
    for (std::size_t i = 0; i < 2; ++i) {
        const VisitedHalf half = i < visited.size() ? visited[i] : VisitedHalf{CellHalf::below, {0, 0}};
        out[3 * i + 1] = half.half == CellHalf::above ? 1 : 0;
        out[3 * i + 2] = half.range.min;
        out[3 * i + 3] = half.range.max;
    }
}

/// The halves that an answer's numbers stand for; of more than two the first two.
inline std::vector<VisitedHalf> read_halves(std::span<const double> answer) {
    std::vector<VisitedHalf> visited;
    for (std::size_t i = 0; i < 2 && static_cast<double>(i) < answer[0]; ++i)
        visited.push_back(
            {answer[3 * i + 1] == 1 ? CellHalf::above : CellHalf::below, {answer[3 * i + 2], answer[3 * i + 3]}});
    return visited;
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&visited_halves) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    write_halves(function(given.origin, given.direction, given.plane, given.range), out);
}

}  // namespace raylab::grading::halves
