// hint: horizon_edge_forgotten
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double from = dot(normal, a), to = dot(normal, b);
        if (from < 0 && to < 0) continue;
        const Vec3d crossing = from == to ? a : a + (b - a) * (from / (from - to));
        if (from < 0) a = crossing;
        if (to < 0) b = crossing;
        const Vec3d across = cross(b, a);
        const double sine = glm::length(across), angle = std::atan2(sine, dot(a, b));
        if (sine > 0) sum += angle * dot(normal, across) / sine;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
