// hint: three_vertices
// Takes every polygon for a triangle.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> kept;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d a = polygon[i] - point, b = polygon[(i + 1) % 3] - point;
        const double height = dot(normal, a), next = dot(normal, b);
        if (height >= 0) kept.push_back(a);
        if (height * next < 0) kept.push_back((a * next - b * height) / (next - height));
    }
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d a = kept[i], b = kept[(i + 1) % kept.size()], across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += std::atan2(length, dot(a, b)) / length * across;
    }
    return std::max(0.0, dot(normal, sum) / (2 * std::numbers::pi));
}
