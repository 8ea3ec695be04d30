// hint: turned
// Walks around the contour backward.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> kept;
    for (std::size_t i = polygon.size(); i-- > 0;) {
        const Vec3d a = polygon[(i + 1) % polygon.size()] - point, b = polygon[i] - point;
        const double before = dot(normal, a), after = dot(normal, b);
        if ((before < 0) != (after < 0)) kept.push_back((b * before - a * after) / (before - after));
        if (after >= 0) kept.push_back(b);
    }
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d a = kept[i], b = kept[(i + 1) % kept.size()], across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += std::atan2(length, dot(a, b)) / length * across;
    }
    return std::max(0.0, dot(normal, sum) / (2 * std::numbers::pi));
}
