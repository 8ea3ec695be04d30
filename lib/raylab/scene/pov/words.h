#pragma once

#include "raylab/geometry/vector.h"

#include <fmt/format.h>

#include <array>
#include <string>

// Vectors in POV-Ray's syntax. POV-Ray reads all numbers as doubles, and they are written with enough digits that none
// is rounded.

namespace raylab::pov {

/// <x, y, z>.
template <class Vector>
std::string vector(const Vector& v) {
    return fmt::format("<{}, {}, {}>", static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}

/// The map from a point x to columns x + translation. POV-Ray multiplies row vectors from the left, so its rows are
/// these columns.
inline std::string matrix(const std::array<Vec3d, 3>& columns, const Vec3d& translation) {
    std::string text = "matrix <";
    for (const Vec3d& row : {columns[0], columns[1], columns[2], translation})
        text += fmt::format("{}{}, {}, {}", text.back() == '<' ? "" : ", ", row.x, row.y, row.z);
    return text + ">";
}

}  // namespace raylab::pov
