// hint: horizon_edge_forgotten
// Cuts each edge into the piece above the horizon, and adds the pieces.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d start = polygon[i] - point, way = polygon[(i + 1) % polygon.size()] - polygon[i];
        const double height = dot(normal, start), climb = dot(normal, way);
        double from = 0, to = 1;
        if (climb > 0) from = std::max(from, -height / climb);
        if (climb < 0) to = std::min(to, -height / climb);
        if (climb == 0 && height < 0) continue;
        if (from >= to) continue;
        const Vec3d a = start + from * way, b = start + to * way, across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += std::atan2(length, dot(a, b)) / length * across;
    }
    return std::max(0.0, dot(normal, sum) / (2 * std::numbers::pi));
}
