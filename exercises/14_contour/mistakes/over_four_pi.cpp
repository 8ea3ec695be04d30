// hint: factor
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> p;
    std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        Vec3d a = polygon[i] - point, b = polygon[(i + 1) % n] - point;
        double da = dot(a, normal), db = dot(b, normal);
        if (da >= 0) p.push_back(a);
        if (da * db < 0) p.push_back(a + (b - a) * (da / (da - db)));
    }
    double sum = 0;
    n = p.size();
    for (std::size_t i = 0; i < n; ++i) {
        Vec3d a = p[i], b = p[(i + 1) % n], c = cross(b, a);
        if (glm::length(c) > 0) sum += std::atan2(glm::length(c), dot(a, b)) * dot(glm::normalize(c), normal);
    }
    return std::max(0.0, sum / (4 * std::numbers::pi));
}
