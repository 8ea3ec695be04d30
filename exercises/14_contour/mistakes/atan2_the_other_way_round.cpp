// hint: sine_above_cosine
// Gives atan2 the cosine first.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> above;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double from = dot(normal, a), to = dot(normal, b);
        if (from >= 0) above.push_back(a);
        if (from * to < 0) above.push_back(a + from / (from - to) * (b - a));
    }
    double sum = 0;
    for (std::size_t i = 0; i < above.size(); ++i) {
        const Vec3d &a = above[i], &b = above[(i + 1) % above.size()], across = cross(b, a);
        const double sine = glm::length(across);
        if (sine > 0) sum += std::atan2(dot(a, b), sine) * dot(normal, across) / sine;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
