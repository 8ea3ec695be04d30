// hint: no_horizon
// Asks only whether all of the polygon is below the horizon.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    bool visible = false;
    for (const Vec3d& vertex : polygon) visible = visible || dot(normal, vertex - point) > 0;
    if (!visible) return 0;
    Vec3d sum{0, 0, 0};
    Vec3d a = polygon.back() - point;
    for (const Vec3d& vertex : polygon) {
        const Vec3d b = vertex - point, across = cross(b - a, a);
        sum += std::atan2(glm::length(across), dot(a, b)) * glm::normalize(across);
        a = b;
    }
    const double share = dot(normal, sum) / (2 * std::numbers::pi);
    return share > 0 ? share : 0;
}
