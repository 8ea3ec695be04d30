// hint: crossing
// Divides by the sum of the two heights, of which one is negative, where their difference belongs.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d here = polygon[i] - point, there = polygon[(i + 1) % polygon.size()] - point;
        const double h = dot(here, normal), g = dot(there, normal);
        if (h >= 0) kept.push_back(here);
        if ((h > 0 && g < 0) || (h < 0 && g > 0)) kept.push_back(here + h / (h + g) * (there - here));
    }
    double sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d &from = kept[i], &to = kept[(i + 1) % kept.size()];
        const Vec3d across = cross(to, from);
        const double sine = glm::length(across);
        if (sine > 0) sum += std::atan2(sine, dot(from, to)) * dot(normal, across) / sine;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
