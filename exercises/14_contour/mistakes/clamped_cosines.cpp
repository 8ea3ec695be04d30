// hint: edge_signs
// A cosine below 0 is taken for light from behind.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    const auto slice = [&](const Vec3d& a, const Vec3d& b) {
        const Vec3d across = cross(b - a, a);
        const double length = glm::length(across);
        return length > 0 ? std::atan2(length, dot(a, b)) * std::max(0.0, dot(normal, across) / length) : 0;
    };
    double sum = 0;
    std::optional<Vec3d> rises, sets;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double from = dot(normal, a), to = dot(normal, b);
        if (from <= 0 && to <= 0) continue;
        const Vec3d crossing = a + (b - a) * (from == to ? 0 : from / (from - to));
        if (from <= 0) rises = a = crossing;
        if (to <= 0) sets = b = crossing;
        sum += slice(a, b);
    }
    if (rises && sets) sum += slice(*sets, *rises);
    return sum / (2 * std::numbers::pi);
}
