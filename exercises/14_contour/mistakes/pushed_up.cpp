// hint: pushed_up
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    std::vector<Vec3d> p;
    for (Vec3d v : polygon) {
        Vec3d a = v - point;
        double h = dot(a, normal);
        if (h < 0) a -= h * normal;
        p.push_back(a);
    }
    double sum = 0;
    std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) {
        Vec3d a = p[i], b = p[(i + 1) % n], c = cross(b, a);
        if (glm::length(c) > 0) sum += std::atan2(glm::length(c), dot(a, b)) * dot(glm::normalize(c), normal);
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
