#pragma once

#include "raylab/tracer/gouraud_and_phong.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace raylab::grading::mesh_hit {

inline constexpr std::size_t inputs = 24;  // the hit, the way to the light, and how the surface shines
inline constexpr std::size_t most_asked = 6;
inline constexpr std::size_t outputs = 3 + 3 * most_asked;  // by Gouraud, by Phong; how many normals were asked, which

/// The local model of one light that is far away, whose formulas hold for unit normals.
struct Model {
    Vec3d to_light, to_viewer;  // unit
    double ambient, diffuse, specular, shininess;

    double operator()(const Vec3d& normal) const {
        const double incline = dot(normal, to_light);
        if (incline <= 0) return ambient;  // what is no number stays none
        const double mirrored = dot(2 * incline * normal - to_light, to_viewer);
        return ambient + diffuse * incline + (mirrored > 0 ? specular * std::pow(mirrored, shininess) : 0);
    }
};

struct Arguments {
    InterpolatedHit hit;
    Model model;
};

inline Arguments arguments(std::span<const double> in) {
    const auto vector = [&](std::size_t i) { return Vec3d{in[i], in[i + 1], in[i + 2]}; };
    return {{{vector(0), vector(3), vector(6)}, vector(9), in[12], in[13], vector(14)},
            {vector(17), glm::normalize(vector(14)), in[20], in[21], in[22], in[23]}};
}

inline std::vector<double> as_input(const Arguments& given) {
    std::vector<double> in;
    const auto put = [&](const Vec3d& v) { in.insert(in.end(), {v.x, v.y, v.z}); };
    const auto& [normals, face, u, v, to_viewer] = given.hit;
    for (const Vec3d& normal : normals) put(normal);
    put(face);
    in.insert(in.end(), {u, v});
    put(to_viewer);
    put(given.model.to_light);
    in.insert(in.end(), {given.model.ambient, given.model.diffuse, given.model.specular, given.model.shininess});
    return in;
}

/// Answers one case with a function of the slot's type, and writes down for which normals it asked.
inline void answer(decltype(&gouraud_and_phong) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    std::ranges::fill(out, 0);
    std::size_t asked = 0;
    const auto brightness = [&](const Vec3d& normal) {
        for (int i = 0; i < 3 && asked < most_asked; ++i) out[3 + 3 * asked + static_cast<std::size_t>(i)] = normal[i];
        ++asked;
        return given.model(normal);
    };
    const auto [gouraud, phong] = function(given.hit, brightness);
    out[0] = gouraud;
    out[1] = phong;
    out[2] = static_cast<double>(asked);
}

}  // namespace raylab::grading::mesh_hit
