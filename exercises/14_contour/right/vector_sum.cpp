#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    // Lambert's vector of the whole contour: one dot product at the end.
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
        const Vec3d a = kept[i], b = kept[(i + 1) % kept.size()], across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += across * (std::atan2(length, dot(a, b)) / length);
    }
    return std::max(0.0, dot(normal, sum)) / (2 * std::numbers::pi);
}
