#pragma once

#include "number_pairs.h"

#include "raylab/transport/light/light_point.h"

#include <span>
#include <vector>

namespace raylab::grading::light {

inline constexpr std::size_t inputs = 8;           // the light's centre and radius, the lit point, and which numbers
inline constexpr std::size_t outputs = 4 * pairs;  // the point and its density for each pair of numbers

struct Arguments {
    Vec3d center;
    double radius;
    Vec3d from;
    double which;
};

inline Arguments arguments(std::span<const double> in) {
    return {{in[0], in[1], in[2]}, in[3], {in[4], in[5], in[6]}, in[7]};
}

inline std::vector<double> as_input(const Arguments& given) {
    const auto& [c, radius, from, which] = given;
    return {c.x, c.y, c.z, radius, from.x, from.y, from.z, which};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&light_point) function, std::span<const double> in, std::span<double> out) {
    const auto [center, radius, from, which] = arguments(in);
    std::size_t place = 0;
    for (const auto& [u, v] : number_pairs(which)) {
        const auto [point, pdf] = function(center, radius, from, u, v);
        for (const double value : {point.x, point.y, point.z, pdf}) out[place++] = value;
    }
}

/// The answer to one of the pairs.
inline LightPoint chosen(std::span<const double> out, std::size_t i) {
    return {{out[4 * i], out[4 * i + 1], out[4 * i + 2]}, out[4 * i + 3]};
}

}  // namespace raylab::grading::light
