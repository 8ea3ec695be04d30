#pragma once

#include "arguments.h"

#include "raylab/geometry/vector.h"

#include <array>

namespace raylab::grading::normals {

inline Vec3d mapped(const std::array<Vec3d, 3>& columns, const Vec3d& v) {
    return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z;
}

// The truth is computed from the definition of a normal, not by the formula under test: two tangents are transformed as
// directions of the surface, and the normal is perpendicular to both, on the side to which the old normal's tip was
// transformed.
inline Vec3d truth(const Arguments& given) {
    const auto& n = given.normal;
    const Vec3d aside = std::abs(n.x) < std::abs(n.y) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d tangent = cross(n, aside);
    const Vec3d upright =
        cross(mapped(given.columns, glm::normalize(tangent)), mapped(given.columns, glm::normalize(cross(n, tangent))));
    const Vec3d unit = upright / glm::length(upright);
    return dot(unit, mapped(given.columns, n)) < 0 ? -unit : unit;
}

}  // namespace raylab::grading::normals
