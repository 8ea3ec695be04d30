// hint: unequal_areas
// Shares the cells out among two halves of a part, and calls itself for one of them. With an odd number of cells, one
// half has more of them and is no larger.
#include "raylab/sampling/pattern/jittered_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>

std::array<double, 2> raylab::jittered_point(std::uint32_t cell, std::uint32_t count, double u, double v) {
    struct Part {
        double left, right, low, high;
    };
    const auto part_of = [](const auto& again, Part part, std::uint32_t number, std::uint32_t cells) -> Part {
        if (cells == 1) return part;
        const std::uint32_t in_first = cells - cells / 2;
        const bool is_first = number < in_first, is_wide = part.right - part.left >= part.high - part.low;
        const double middle = is_wide ? std::midpoint(part.left, part.right) : std::midpoint(part.low, part.high);
        if (is_wide)
            (is_first ? part.right : part.left) = middle;
        else
            (is_first ? part.high : part.low) = middle;
        return is_first ? again(again, part, number, in_first) : again(again, part, number - in_first, cells / 2);
    };
    const Part part = part_of(part_of, {0, 1, 0, 1}, cell, count);
    const double below_one = std::nextafter(1.0, 0.0);
    return {std::min(std::lerp(part.left, part.right, u), below_one),
            std::min(std::lerp(part.low, part.high, v), below_one)};
}
