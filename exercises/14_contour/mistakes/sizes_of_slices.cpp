// hint: edge_signs
// An area cannot be negative, so each slice counts by its size.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    const Vec3d front = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    if (dot(front, point - polygon[0]) <= 0) return 0;
    std::vector<Vec3d> above;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double from = dot(normal, a), to = dot(normal, b);
        if (from >= 0) above.push_back(a);
        if ((from >= 0) != (to >= 0)) above.push_back(a + (b - a) * (from / (from - to)));
    }
    double sum = 0;
    for (std::size_t i = 0; i < above.size(); ++i) {
        const Vec3d a = above[i], b = above[(i + 1) % above.size()], across = cross(b - a, a);
        const double sine = glm::length(across), angle = std::atan2(sine, dot(a, b));
        if (sine > 0) sum += std::abs(angle * dot(normal, across) / sine);
    }
    return sum / (2 * std::numbers::pi);
}
