// hint: behind_counts
// Turns polygons that are seen from behind.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> vertices(polygon.begin(), polygon.end());
    const Vec3d front = cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
    if (dot(front, point - vertices[0]) < 0) std::reverse(vertices.begin(), vertices.end());
    std::vector<Vec3d> kept;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3d a = vertices[i] - point, b = vertices[(i + 1) % vertices.size()] - point;
        const double before = dot(normal, a), after = dot(normal, b);
        if (before >= 0) kept.push_back(a);
        if ((before < 0) != (after < 0)) kept.push_back((b * before - a * after) / (before - after));
    }
    double sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d a = kept[i], b = kept[(i + 1) % kept.size()], across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += std::atan2(length, dot(a, b)) * dot(normal, across) / length;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
