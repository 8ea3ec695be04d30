// hint: cut
// Where the contour comes up, the vertex above comes into the list before the crossing: the walk goes back and forth.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> kept;
    Vec3d last = polygon.back() - point;
    for (const Vec3d& vertex : polygon) {
        const Vec3d next = vertex - point;
        const double h = dot(last, normal), g = dot(next, normal);
        if (g >= 0) kept.push_back(next);
        if ((h > 0 && g < 0) || (h < 0 && g > 0)) kept.push_back(last + h / (h - g) * (next - last));
        last = next;
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
