#pragma once

#include "raylab/geometry/vector.h"

#include <functional>
#include <optional>

namespace raylab {

/// The surface that a ray hit first, as one level of Whitted's recursion needs it.
struct TracedSurface {
    Vec3d local;     // linear RGB: its own colour, by all lights that reach it
    double kr, kt;   // the shares of what mirror and refraction bring; kr + kt <= 1
    Vec3d mirrored;  // unit: where a mirror ray leaves
    std::optional<Vec3d>
        refracted;  // unit: where a refracted ray leaves; absent: an opaque surface, or total internal reflection
};

/// The parts of one level of the recursion.
struct TracedLevel {
    int depth;                             // of the ray; the eye ray has depth 1
    int limit;                             // the depth of the deepest ray there may be
    std::optional<TracedSurface> nearest;  // absent: the ray hits nothing
    Vec3d background;                      // linear RGB: what a ray brings that hits nothing

    /// The colour along a ray of this depth that leaves the surface in this direction: the next level.
    std::function<Vec3d(const Vec3d& direction, int depth)> trace;
};

/// The colour along a ray by Whitted's recursion: I = I_local + k_r I_reflected + k_t I_transmitted, the background
/// where nothing is hit. No ray is traced beyond the limit, nor where its share is 0. Where kt > 0 and nothing is
/// refracted (total internal reflection), the mirror ray has the share of both, kr + kt. This is the slot of exercise
/// 07b.
Vec3d traced_color(const TracedLevel& level);

}  // namespace raylab
