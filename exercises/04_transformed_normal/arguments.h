#pragma once

#include "raylab/geometry/transformed_normal.h"

#include <span>

namespace raylab::grading::normals {

inline constexpr std::size_t inputs = 12;  // three columns, and the normal before
inline constexpr std::size_t outputs = 3;  // the normal after

struct Arguments {
    std::array<Vec3d, 3> columns;
    Vec3d normal;
};

inline Arguments arguments(std::span<const double> in) {
    return {{Vec3d{in[0], in[1], in[2]}, Vec3d{in[3], in[4], in[5]}, Vec3d{in[6], in[7], in[8]}},
            {in[9], in[10], in[11]}};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&transformed_normal) function, std::span<const double> in, std::span<double> out) {
    const auto [columns, normal] = arguments(in);
    const auto result = function(columns, normal);
    out[0] = result.x;
    out[1] = result.y;
    out[2] = result.z;
}

}  // namespace raylab::grading::normals
