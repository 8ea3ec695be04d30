#pragma once

#include "raylab/tracer/phong_specular.h"

#include <span>

namespace raylab::grading::highlight {

inline constexpr std::size_t inputs = 10;  // normal, to the light, to the viewer, shininess
inline constexpr std::size_t outputs = 1;  // the highlight

struct Arguments {
    Vec3d normal, to_light, to_viewer;
    double shininess;
};

inline Arguments arguments(std::span<const double> in) {
    return {{in[0], in[1], in[2]}, {in[3], in[4], in[5]}, {in[6], in[7], in[8]}, in[9]};
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&phong_specular) function, std::span<const double> in, std::span<double> out) {
    const auto [normal, to_light, to_viewer, shininess] = arguments(in);
    out[0] = function(normal, to_light, to_viewer, shininess);
}

}  // namespace raylab::grading::highlight
