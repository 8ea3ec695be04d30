// hint: another_horizon
// or: no_horizon
// Takes z for the height, whatever the patch's normal is.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> above;
    Vec3d a = polygon.back() - point;
    for (const Vec3d& vertex : polygon) {
        const Vec3d b = vertex - point;
        const double from = a.z, to = b.z;
        if ((from < 0) != (to < 0)) above.push_back(a + from / (from - to) * (b - a));
        if (to >= 0) above.push_back(b);
        a = b;
    }
    double sum = 0;
    for (std::size_t i = 0; i < above.size(); ++i) {
        const Vec3d &one = above[i], &next = above[(i + 1) % above.size()];
        const Vec3d across = cross(next, one);
        const double sine = glm::length(across);
        if (sine > 0) sum += std::atan2(sine, dot(one, next)) * dot(normal, across) / sine;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
