#pragma once

#include "raylab/geometry/box_entry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace raylab::grading::boxes {

inline constexpr std::size_t inputs = 14;  // origin, direction, range, low, high
inline constexpr std::size_t outputs = 2;  // 1 and t: the ray is in the box from t on; 0: it never is in the box

struct Arguments {
    RayOf<double> ray;
    Vec3d low, high;
};

inline Arguments arguments(std::span<const double> in) {
    const auto vector = [&](std::size_t i) { return Vec3d{in[i], in[i + 1], in[i + 2]}; };
    return {{vector(0), vector(3), {in[6], in[7]}}, vector(8), vector(11)};
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [ray, low, high] = given;
    return {ray.origin.x,  ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.range.min,
            ray.range.max, low.x,        low.y,        low.z,           high.x,          high.y,          high.z};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&box_entry) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    const auto t = function(given.ray, given.low, given.high);
    out[0] = t ? 1 : 0;
    out[1] = t.value_or(0);
}

}  // namespace raylab::grading::boxes
