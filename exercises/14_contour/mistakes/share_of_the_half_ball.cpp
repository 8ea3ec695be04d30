// hint: solid_angle
// The excess of the angles over those of a flat polygon is the solid angle; no cosine to the normal comes in.
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
        if ((h > 0 && g < 0) || (h < 0 && g > 0)) kept.push_back(here + h / (h - g) * (there - here));
    }
    double angle = 0;
    for (std::size_t i = 2; i < kept.size(); ++i) {
        const Vec3d a = glm::normalize(kept[0]), b = glm::normalize(kept[i - 1]), c = glm::normalize(kept[i]);
        angle -= 2 * std::atan2(dot(a, cross(b, c)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
    }
    return std::max(0.0, angle / (2 * std::numbers::pi));
}
