// hint: acos
// The dot product of two unit vectors may be rounded to more than 1.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>
#include <optional>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    const auto edge = [&](const Vec3d& from, const Vec3d& to) {
        const Vec3d a = glm::normalize(from), b = glm::normalize(to), across = cross(to - from, from);
        return std::acos(dot(a, b)) * dot(normal, glm::normalize(across));
    };
    double sum = 0;
    std::optional<Vec3d> rises, sets;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double from = dot(normal, a), to = dot(normal, b);
        if (from <= 0 && to <= 0) continue;
        if (from < 0) rises = a = a + (b - a) * (from / (from - to));
        if (to < 0) sets = b = a + (b - a) * (dot(normal, a) / (dot(normal, a) - to));
        sum += edge(a, b);
    }
    if (rises && sets) sum += edge(*sets, *rises);
    return sum > 0 ? sum / (2 * std::numbers::pi) : 0;
}
