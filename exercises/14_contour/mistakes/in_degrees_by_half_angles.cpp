// hint: degrees
// Turns each angle into degrees, and divides the sum by the full angle in radians.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>
#include <optional>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    const auto term = [&](const Vec3d& a, const Vec3d& b) {
        const Vec3d u = glm::normalize(a), v = glm::normalize(b), across = cross(b - a, a);
        const double angle = glm::degrees(2 * std::atan2(glm::length(u - v), glm::length(u + v)));
        return angle > 0 ? angle * dot(normal, glm::normalize(across)) : 0;
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
        sum += term(a, b);
    }
    if (rises && sets) sum += term(*sets, *rises);
    return sum > 0 ? sum / (2 * std::numbers::pi) : 0;
}
