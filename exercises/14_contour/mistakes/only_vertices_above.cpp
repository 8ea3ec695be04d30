// hint: vertices_dropped
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> kept;
    std::ranges::copy_if(polygon, std::back_inserter(kept),
                         [&](const Vec3d& vertex) { return dot(normal, vertex - point) > 0; });
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d a = kept[i] - point, b = kept[(i + 1) % kept.size()] - point, across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += std::atan2(length, dot(a, b)) / length * across;
    }
    return std::max(0.0, dot(normal, sum) / (2 * std::numbers::pi));
}
