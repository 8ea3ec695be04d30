// hint: point_forgotten
// Works edge by edge with the vertices as they stand, as if all of them were seen from the origin.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>
#include <optional>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    Vec3d lambert{0, 0, 0};
    const auto walk = [&](const Vec3d& a, const Vec3d& b) {
        const Vec3d across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) lambert += std::atan2(length, dot(a, b)) / length * across;
    };
    std::optional<Vec3d> rises, sets;
    Vec3d last = polygon.back();
    for (const Vec3d& vertex : polygon) {
        const double before = dot(normal, last), after = dot(normal, vertex);
        const Vec3d crossing = before == after ? last : (vertex * before - last * after) / (before - after);
        if (before < 0 && after >= 0) rises = crossing;
        if (before >= 0 && after < 0) sets = crossing;
        if (before >= 0 || after >= 0) walk(before < 0 ? crossing : last, after < 0 ? crossing : vertex);
        last = vertex;
    }
    if (rises && sets) walk(*sets, *rises);
    const double sum = dot(normal, lambert);
    return sum > 0 ? sum / (2 * std::numbers::pi) : 0;
}
