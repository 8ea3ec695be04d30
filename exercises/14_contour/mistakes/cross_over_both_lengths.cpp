// hint: sine_for_angle
// The cross product over the lengths of both ends has the sine for its length, where the angle belongs.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> kept;
    Vec3d last = polygon.back() - point;
    for (const Vec3d& vertex : polygon) {
        const Vec3d next = vertex - point;
        const double before = dot(normal, last), after = dot(normal, next);
        if ((before < 0) != (after < 0)) kept.push_back((next * before - last * after) / (before - after));
        if (after >= 0) kept.push_back(next);
        last = next;
    }
    Vec3d lambert{0, 0, 0};
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d &a = kept[i], &b = kept[(i + 1) % kept.size()];
        lambert += cross(b - a, a) / (glm::length(a) * glm::length(b));
    }
    return std::max(0.0, dot(normal, lambert)) / (2 * std::numbers::pi);
}
