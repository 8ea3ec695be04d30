// hint: from_the_middle
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <algorithm>
#include <numbers>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    Vec3d middle{0, 0, 0}, area{0, 0, 0};
    for (const Vec3d& vertex : polygon) middle += vertex;
    middle /= static_cast<double>(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
        area += cross(polygon[i] - middle, polygon[(i + 1) % polygon.size()] - middle) / 2.0;
    const Vec3d way = middle - point;
    const double distance = glm::length(way);
    const double here = dot(normal, way) / distance, there = -dot(area, way) / distance;
    if (here <= 0 || there <= 0) return 0;
    return here * there / (std::numbers::pi * distance * distance);
}
