#pragma once

#include "exercise.h"
#include "truth.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::grading::tree {

// Eight balls in a tree: grey by what the function hits, and the redder the more it asks.
inline constexpr int picture_width = 160, picture_height = 120;

inline const std::vector<SphereOf<double>>& balls() {
    static const std::vector<SphereOf<double>> all{
        {{-2.2, -0.9, 1}, 0.9}, {{-1.1, 0.4, -1}, 1.1}, {{-1.9, 1.1, 0.2}, 0.6}, {{-0.4, -1.2, 1.6}, 0.6},
        {{1.9, 0.8, -0.8}, 1},  {{0.6, 1.2, 0.6}, 0.7}, {{1.4, -0.7, 1.2}, 0.9}, {{0.4, -0.2, -2.2}, 1.3}};
    return all;
}

inline Arguments looking(int x, int y) {
    const double scale = 5.6 / picture_height;
    const Vec3d eye{0.3, 0.2, 9};
    const Vec3d target{(x + 0.5 - 0.5 * picture_width) * scale, (0.5 * picture_height - y - 0.5) * scale, 0};
    return {{eye, (target - eye) / 9.0, {0, 1e9}}, balls()};
}

inline std::vector<Case> pixel_cases(int x, int y) { return {{"", Case::Kind::graded, as_input(looking(x, y))}}; }

inline Pixel shade(int x, int y, std::span<const double> answer) {
    const Arguments given = looking(x, y);
    const auto work = cast<float>(std::clamp(answer[2] / 60, 0.0, 1.0));
    const Vec3d point = given.ray.origin + answer[1] * given.ray.direction;
    const bool hit = answer[0] == 1 && std::isfinite(answer[1]);
    const auto grey = hit ? cast<float>(std::clamp(0.35 + 0.12 * point.z, 0.05, 0.7)) : 0.02f;
    return {std::min(1.0f, grey + work), grey, grey};
}

}  // namespace raylab::grading::tree
