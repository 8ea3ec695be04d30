#pragma once

#include "arguments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// The truth, in more digits than a double has: the polygon clipped to the
// horizon (Sutherland and Hodgman), then the sum over its edges.

namespace raylab::grading::contour {

using Wide = glm::vec<3, long double, glm::defaultp>;

struct Heights {
    double least, most;  // of the vertices over the point's horizon
};

inline Heights heights(const Arguments& given) {
    Heights found{0, 0};
    for (std::size_t i = 0; i < given.polygon.size(); ++i) {
        const double height = dot(given.normal, given.polygon[i] - given.point);
        found.least = i == 0 ? height : std::min(found.least, height);
        found.most = i == 0 ? height : std::max(found.most, height);
    }
    return found;
}

inline std::vector<Wide> above_horizon(const Arguments& given) {
    std::vector<Wide> clipped;
    for (std::size_t i = 0; i < given.polygon.size(); ++i) {
        const Wide a = Wide(given.polygon[i]) - Wide(given.point);
        const Wide b = Wide(given.polygon[(i + 1) % given.polygon.size()]) - Wide(given.point);
        const long double height_a = dot(Wide(given.normal), a), height_b = dot(Wide(given.normal), b);
        if (height_a >= 0) clipped.push_back(a);
        if ((height_a > 0 && height_b < 0) || (height_a < 0 && height_b > 0))
            clipped.push_back(a + (b - a) * (height_a / (height_a - height_b)));
    }
    return clipped;
}

/// Whether the point is in front of the polygon: not in its plane, where nothing arrives, and not behind it.
inline bool is_in_front(const Arguments& given) {
    Wide area_vector{0, 0, 0};
    const Wide first(given.polygon[0]);
    for (std::size_t i = 2; i < given.polygon.size(); ++i)
        area_vector += cross(Wide(given.polygon[i - 1]) - first, Wide(given.polygon[i]) - first);
    return dot(area_vector, Wide(given.point) - first) > 0;
}

inline double truth(const Arguments& given) {
    if (!is_in_front(given)) return 0;
    const auto clipped = above_horizon(given);
    long double sum = 0;
    for (std::size_t i = 0; i < clipped.size(); ++i) {
        const Wide a = clipped[i], b = clipped[(i + 1) % clipped.size()], across = cross(b - a, a);
        const long double sine = glm::length(across);
        if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(Wide(given.normal), across) / sine;
    }
    return static_cast<double>(std::max(0.0L, sum / (2 * std::numbers::pi_v<long double>)));
}

}  // namespace raylab::grading::contour
