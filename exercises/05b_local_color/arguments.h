#pragma once

#include "raylab/tracer/local_color.h"

#include <vector>

namespace raylab::grading::local {

inline constexpr std::size_t most_lights = 2;
inline constexpr std::size_t inputs = 17 + 9 * most_lights;  // the surface, how many lights, the lights
inline constexpr std::size_t outputs = 3;                    // the colour

struct Arguments {
    LocalSurface surface;
    std::vector<IncidentLight> lights;
};

inline Arguments arguments(std::span<const double> in) {
    const auto vector = [&](std::size_t i) { return Vec3d{in[i], in[i + 1], in[i + 2]}; };
    Arguments given{{vector(0), vector(3), vector(6), vector(9), vector(12), in[15]}, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(in[16]); ++i)
        given.lights.push_back({vector(17 + 9 * i), vector(20 + 9 * i), vector(23 + 9 * i)});
    return given;
}

inline std::vector<double> as_input(const Arguments& given) {
    std::vector<double> in;
    const auto put = [&](const Vec3d& v) { in.insert(in.end(), {v.x, v.y, v.z}); };
    const auto& [normal, to_viewer, unlit, diffuse, specular, shininess] = given.surface;
    for (const Vec3d& v : {normal, to_viewer, unlit, diffuse, specular}) put(v);
    in.push_back(shininess);
    in.push_back(static_cast<double>(given.lights.size()));
    for (const auto& [way, color, attenuation] : given.lights)
        for (const Vec3d& v : {way, color, attenuation}) put(v);
    in.resize(inputs);
    return in;
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&local_color) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    const Vec3d color = function(given.surface, given.lights);
    for (int i = 0; i < 3; ++i) out[static_cast<std::size_t>(i)] = color[i];
}

}  // namespace raylab::grading::local
