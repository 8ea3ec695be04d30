#pragma once

#include "raylab/geometry/vector.h"

#include <fmt/format.h>

#include <array>
#include <string>

// How POV-Ray writes vectors. All our numbers are read by it as doubles, and none is rounded on the way.

namespace raylab::pov {

/// <x, y, z>.
template <class Vector>
std::string vector(const Vector& v) {
    return fmt::format("<{}, {}, {}>", static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}

/// The map of a point x to columns x + translation. POV-Ray multiplies rows from the left: its rows are our columns.
inline std::string matrix(const std::array<Vec3d, 3>& columns, const Vec3d& translation) {
    std::string text = "matrix <";
    for (const Vec3d& row : {columns[0], columns[1], columns[2], translation})
        text += fmt::format("{}{}, {}, {}", text.back() == '<' ? "" : ", ", row.x, row.y, row.z);
    return text + ">";
}

}  // namespace raylab::pov
