#pragma once

#include "arguments.h"
#include "spread.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

// What an answer's points say of the cells, and what is wrong with them. Which cells a function makes is its own
// affair, as long as they are rectangles of equal area that cover the square.

namespace raylab::grading::jitter {

inline constexpr double rounding = 1e-9;

struct CellBox {
    double left, right, low, high;
    double width() const { return right - left; }
    double height() const { return high - low; }
    double area() const { return width() * height(); }
};

inline std::vector<CellBox> boxes_of(std::size_t count, std::span<const double> answer) {
    std::vector<CellBox> all;
    for (std::size_t cell = 0; cell < count; ++cell) {
        const auto corners = answer.subspan(2 * pairs + 4 * cell, 4);
        const auto [left, right] = std::minmax(corners[0], corners[2]);
        const auto [low, high] = std::minmax(corners[1], corners[3]);
        all.push_back({left, right, low, high});
    }
    return all;
}

inline double shared_area(const CellBox& a, const CellBox& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.high, b.high) - std::max(a.low, b.low);
    return std::max(0.0, width) * std::max(0.0, height);
}

inline bool all_finite(std::span<const double> answer) {
    return std::ranges::all_of(answer, [](double x) { return std::isfinite(x); });
}

/// Whether all points are in the unit square, its sides included.
inline bool in_square(std::span<const double> answer) {
    return std::ranges::all_of(answer, [](double x) { return x >= 0 && x <= 1; });
}

inline std::string in_words(std::size_t cell, const CellBox& box) {
    return fmt::format("cell {} from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}), of area {:.6g}", cell, box.left, box.low,
                       box.right, box.high, box.area());
}

/// What is wrong with an answer's cells; absent where nothing is.
struct CellFault {
    enum class Kind { area, overlap, side } kind;
    std::string expected, got;
};

inline std::optional<CellFault> fault_of(const std::vector<CellBox>& boxes) {
    using enum CellFault::Kind;
    const double share = 1 / static_cast<double>(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (std::abs(boxes[i].area() - share) > rounding)
            return CellFault{area, fmt::format("{} cells of area {:.6g}", boxes.size(), share), in_words(i, boxes[i])};
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (shared_area(boxes[i], boxes[k]) > rounding)
                return CellFault{overlap, "cells that share no area",
                                 in_words(k, boxes[k]) + ", and " + in_words(i, boxes[i])};
    const double longest = 2 * std::sqrt(share);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (std::max(boxes[i].width(), boxes[i].height()) > longest + rounding)
            return CellFault{side, fmt::format("no side longer than {:.6g}", longest), in_words(i, boxes[i])};
    return std::nullopt;
}

/// Where in its cell a pair's point lies, from 0 to 1 along both sides.
inline DrawnShare share_in_cell(const CellBox& box, std::span<const double> answer, std::size_t i) {
    return {(answer[2 * i] - box.left) / box.width(), (answer[2 * i + 1] - box.low) / box.height()};
}

inline std::vector<DrawnShare> shares_in_cells(const std::vector<CellBox>& boxes, std::span<const double> answer) {
    std::vector<DrawnShare> all;
    for (std::size_t i = 0; i < pairs; ++i)
        all.push_back(share_in_cell(boxes[cell_of_pair(i, boxes.size())], answer, i));
    return all;
}

}  // namespace raylab::grading::jitter
