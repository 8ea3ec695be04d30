#pragma once

#include "raylab/tracer/traced_color.h"

#include <span>

namespace raylab::grading::trace {

// Depth, limit, whether a surface is hit, its local colour, kr, kt, the mirror ray's direction and the colour it
// returns, whether there is a refracted ray, its direction and colour, the background.
inline constexpr std::size_t inputs = 24;

// The colour; the number of mirror rays that were traced and the depth that was passed for the last of them; the same
// of refracted rays; the number of other rays.
inline constexpr std::size_t outputs = 8;

struct Arguments {
    TracedLevel level;  // without `trace`
    Vec3d mirrored_brings, refracted_brings;
};

inline Vec3d vector(std::span<const double> in, std::size_t from) { return {in[from], in[from + 1], in[from + 2]}; }

inline Arguments arguments(std::span<const double> in) {
    TracedSurface surface{.local = vector(in, 3), .kr = in[6], .kt = in[7], .mirrored = vector(in, 8), .refracted = {}};
    if (in[14] != 0) surface.refracted = vector(in, 15);
    TracedLevel level{.depth = static_cast<int>(in[0]),
                      .limit = static_cast<int>(in[1]),
                      .nearest = {},
                      .background = vector(in, 21),
                      .trace = {}};
    if (in[2] != 0) level.nearest = surface;
    return {level, vector(in, 11), vector(in, 18)};
}

/// Whether a direction is this one, or was made unit once more.
inline bool is_direction(const Vec3d& given, const Vec3d& direction) {
    return glm::length(given - direction) <= 1e-12 * glm::length(direction);
}

/// Answers one case with a function of the slot's type.
inline void answer(decltype(&traced_color) function, std::span<const double> in, std::span<double> out) {
    auto [level, mirrored_brings, refracted_brings] = arguments(in);
    double rays[2] = {0, 0}, depths[2] = {0, 0}, elsewhere = 0;
    level.trace = [&, mirrored_brings = mirrored_brings, refracted_brings = refracted_brings](const Vec3d& direction,
                                                                                              int depth) {
        const bool mirrored = level.nearest && is_direction(direction, level.nearest->mirrored);
        if (!mirrored &&
            !(level.nearest && level.nearest->refracted && is_direction(direction, *level.nearest->refracted))) {
            ++elsewhere;
            return Vec3d{0, 0, 0};
        }
        ++rays[mirrored ? 0 : 1];
        depths[mirrored ? 0 : 1] = depth;
        return mirrored ? mirrored_brings : refracted_brings;
    };
    const Vec3d color = function(level);
    const double answers[outputs] = {color.x, color.y, color.z, rays[0], depths[0], rays[1], depths[1], elsewhere};
    for (std::size_t i = 0; i < outputs; ++i) out[i] = answers[i];
}

}  // namespace raylab::grading::trace
