// hint: crossing
// In coordinates in which the normal is z, an edge that changes its side is followed for half of its length.
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    const Vec3d x = glm::normalize(cross(std::abs(normal.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, normal));
    const Vec3d y = cross(normal, x);
    std::vector<Vec3d> local, kept;
    for (const Vec3d& vertex : polygon)
        local.push_back({dot(vertex - point, x), dot(vertex - point, y), dot(vertex - point, normal)});
    for (std::size_t i = 0; i < local.size(); ++i) {
        const Vec3d a = local[i], way = local[(i + 1) % local.size()] - a;
        const bool is_above = a.z >= 0, stays = is_above == (a.z + way.z >= 0);
        if (is_above) kept.push_back(a);
        if (!stays) kept.push_back(a + 0.5 * way);
    }
    double sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d a = kept[i], b = kept[(i + 1) % kept.size()], across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += std::atan2(length, dot(a, b)) / length * across.z;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
