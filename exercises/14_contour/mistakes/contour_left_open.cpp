// hint: last_edge_forgotten
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double height = dot(normal, a), next = dot(normal, b);
        if (height >= 0) kept.push_back(a);
        if (height * next < 0) kept.push_back((a * next - b * height) / (next - height));
    }
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 1; i < kept.size(); ++i) {
        const Vec3d across = cross(kept[i] - kept[i - 1], kept[i - 1]);
        const double length = glm::length(across);
        if (length > 0) sum += across / length * std::atan2(length, dot(kept[i - 1], kept[i]));
    }
    const double share = dot(normal, sum) / 2 / std::numbers::pi;
    return share < 0 ? 0 : share;
}
