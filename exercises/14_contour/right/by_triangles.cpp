#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    // Each triangle of a fan on its own; the sums along an inner edge, which has
    // a triangle on either side, cancel.
    double factor = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const std::array triangle{polygon[0] - point, polygon[k - 1] - point, polygon[k] - point};
        std::vector<Vec3d> above;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3d a = triangle[i], b = triangle[(i + 1) % 3];
            const double from = dot(normal, a), to = dot(normal, b);
            if (from > 0) above.push_back(a);
            if (from * to < 0) above.push_back((a * to - b * from) / (to - from));
        }
        Vec3d sum{0, 0, 0};
        for (std::size_t i = 0; i < above.size(); ++i) {
            const Vec3d a = above[i], b = above[(i + 1) % above.size()], across = cross(b - a, a);
            const double sine = glm::length(across);
            if (sine > 0) sum += across * (std::atan2(sine, dot(a, b)) / sine);
        }
        factor += dot(normal, sum) / (2 * std::numbers::pi);
    }
    return std::max(0.0, factor);
}
