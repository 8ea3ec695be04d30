#pragma once

#include "arguments.h"
#include "exercise.h"

#include <cmath>
#include <limits>

namespace raylab::grading::drawing_depth {

// A floor that runs far off, two walls and a leaning triangle, by their depths alone: of each pixel the nearest one,
// with a stripe at every unit of depth.
inline constexpr int picture_width = 200, picture_height = 130;

struct Sheet {
    std::array<DrawnCorner, 3> corners;
    Pixel color;
};

/// A corner at (x, y, z) in front of the eye, y upward, as it is drawn.
inline DrawnCorner drawn_corner(double x, double y, double z) {
    constexpr double scale = 110;  // pixels at depth 1
    return {picture_width / 2.0 + scale * x / z, picture_height / 2.0 - scale * y / z, z};
}

inline const std::vector<Sheet>& sheets() {
    static const std::vector<Sheet> all{
        {{drawn_corner(-3, -1, 2), drawn_corner(3, -1, 2), drawn_corner(0, -1, 40)}, {0.55f, 0.55f, 0.5f}},
        {{drawn_corner(-2.2, -1, 2.5), drawn_corner(-2.6, 2.5, 14), drawn_corner(-1.5, -1, 14)}, {0.85f, 0.45f, 0.15f}},
        {{drawn_corner(2.5, -1, 12), drawn_corner(1.9, 1.4, 6), drawn_corner(1.7, -1, 2.8)}, {0.15f, 0.5f, 0.7f}},
        {{drawn_corner(-0.9, -1, 4), drawn_corner(1.1, -0.6, 7), drawn_corner(0.4, 1.1, 4.5)}, {0.3f, 0.65f, 0.45f}}};
    return all;
}

inline std::vector<Case> pixel_cases(int x, int y) {
    std::vector<Case> all;
    for (const Sheet& sheet : sheets())
        all.push_back({"", Case::Kind::graded, as_input({sheet.corners, x + 0.5, y + 0.5})});
    return all;
}

inline Pixel shade(int, int, std::span<const double> answers) {
    double nearest = std::numeric_limits<double>::infinity();
    Pixel color{0.93f, 0.94f, 0.96f};
    for (std::size_t i = 0; i < sheets().size(); ++i) {
        const double depth = answers[2 * i + 1];
        if (answers[2 * i] != 1 || !(depth < nearest)) continue;
        nearest = depth;
        const float light = depth - std::floor(depth) < 0.25 ? 0.55f : 1.0f;
        const Pixel& own = sheets()[i].color;
        color = {own.r * light, own.g * light, own.b * light};
    }
    return color;
}

}  // namespace raylab::grading::drawing_depth
