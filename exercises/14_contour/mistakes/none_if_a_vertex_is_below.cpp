// hint: horizon_edge_forgotten
// or: cut
// Lets a polygon count only if all of it is above the horizon.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point, across = cross(b, a);
        if (dot(normal, a) < 0) return 0;
        sum += std::atan2(glm::length(across), dot(a, b)) * dot(normal, across) / glm::length(across);
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
