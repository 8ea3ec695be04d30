#pragma once

#include "raylab/tracer/refracted_direction.h"

#include <span>

namespace raylab::grading::refraction {

inline constexpr std::size_t inputs = 8;   // direction, normal, index of refraction before and behind the surface
inline constexpr std::size_t outputs = 4;  // 1 or 0 for refracted or totally reflected, and the direction

struct Arguments {
    Vec3d direction, normal;
    double ior_before, ior_behind;
};

inline Arguments arguments(std::span<const double> in) {
    return {{in[0], in[1], in[2]}, {in[3], in[4], in[5]}, in[6], in[7]};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&refracted_direction) function, std::span<const double> in, std::span<double> out) {
    const auto [direction, normal, ior_before, ior_behind] = arguments(in);
    const auto refracted = function(direction, normal, ior_before, ior_behind);
    const Vec3d result = refracted.value_or(Vec3d{0, 0, 0});
    out[0] = refracted.has_value();
    out[1] = result.x;
    out[2] = result.y;
    out[3] = result.z;
}

}  // namespace raylab::grading::refraction
