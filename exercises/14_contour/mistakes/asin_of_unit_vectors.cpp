// hint: asin
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
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
    Vec3d sum{0, 0, 0};
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d across = cross(glm::normalize(kept[(i + 1) % kept.size()]), glm::normalize(kept[i]));
        const double sine = glm::length(across);
        if (sine > 0) sum += across / sine * std::asin(std::min(1.0, sine));
    }
    return std::max(0.0, dot(normal, sum)) / (2 * std::numbers::pi);
}
