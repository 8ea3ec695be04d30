#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    // In coordinates in which the normal is z: heights are z, and of each cross product z is all that counts.
    const Vec3d x = glm::normalize(cross(std::abs(normal.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, normal));
    const Vec3d y = cross(normal, x);
    std::vector<Vec3d> local, kept;
    for (const Vec3d& vertex : polygon) {
        const Vec3d way = vertex - point;
        local.push_back({dot(way, x), dot(way, y), dot(way, normal)});
    }
    for (std::size_t i = 0; i < local.size(); ++i) {
        const Vec3d& a = local[i];
        const Vec3d& b = local[(i + 1) % local.size()];
        if (a.z >= 0) kept.push_back(a);
        if (a.z * b.z < 0) kept.push_back(a + (b - a) * (a.z / (a.z - b.z)));
    }
    double sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const Vec3d a = kept[i], b = kept[(i + 1) % kept.size()], across = cross(b - a, a);
        const double length = glm::length(across);
        if (length > 0) sum += std::atan2(length, dot(a, b)) / length * across.z;
    }
    return std::max(0.0, sum / (2 * std::numbers::pi));
}
