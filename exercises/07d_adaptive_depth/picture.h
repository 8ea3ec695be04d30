#pragma once

#include "arguments.h"
#include "exercise.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading::branches {

// To the right the share of two facing panes grows from 0 to 1, downward the depth from 1 to 24; what is mirrored is
// followed where it is red, what shines through where it is blue.
inline constexpr int picture_width = 192, picture_height = 144;
inline constexpr int deepest = 24, pixels_a_level = picture_height / deepest;

inline std::vector<Case> pixel_cases(int x, int y) {
    const double rho = (x + 1.0) / picture_width;
    const int depth = y / pixels_a_level;
    return {{"", Case::Kind::graded,
             as_input({std::pow(rho, depth), 0.7 * rho, 0.3 * rho, deepest - 1 - depth, 1, rho, 0.05})}};
}

inline Pixel shade(int, int y, std::span<const double> answer) {
    const auto channel = [](double weight) {
        return std::isfinite(weight) && weight > 0 ? cast<float>(0.15 + 0.85 * std::min(1.0, std::sqrt(weight)))
                                                   : 0.02f;
    };
    const float line = y % pixels_a_level == 0 ? 0.05f : 0.02f;
    return {channel(answer[0]), line, channel(answer[1])};
}

}  // namespace raylab::grading::branches
