// hint: sine_for_angle
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
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
        Vec3d a = glm::normalize(p[i]), b = glm::normalize(p[(i + 1) % n]);
        sum += dot(cross(b, a), normal);
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
