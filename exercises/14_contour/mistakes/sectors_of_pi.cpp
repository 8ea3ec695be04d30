// hint: pi_for_two_pi
// Takes the area of a sector for its angle.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>
#include <optional>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    const auto projected = [&](const Vec3d& a, const Vec3d& b) {
        const Vec3d u = glm::normalize(a), v = glm::normalize(b), across = cross(b - a, a);
        const double sector = 2 * std::atan2(glm::length(u - v), glm::length(u + v));
        return sector > 0 ? sector * dot(normal, glm::normalize(across)) : 0;
    };
    double area = 0;
    std::optional<Vec3d> rises, sets;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double from = dot(normal, a), to = dot(normal, b);
        if (from <= 0 && to <= 0) continue;
        const Vec3d crossing = a + (b - a) * (from == to ? 0 : from / (from - to));
        if (from <= 0) rises = a = crossing;
        if (to <= 0) sets = b = crossing;
        area += projected(a, b);
    }
    if (rises && sets) area += projected(*sets, *rises);
    return area > 0 ? area / std::numbers::pi : 0;
}
