// hint: local_twice
// Each ray makes a whole colour of the surface, its own light in it, and two rays add two such colours.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;
    if (level.depth == level.limit || s.kr + s.kt == 0) return s.local;

    const auto seen = [&](double share, const Vec3d& way) {
        return s.local + share * level.trace(way, level.depth + 1);
    };
    if (!s.refracted) return seen(s.kr + s.kt, s.mirrored);
    if (s.kt == 0) return seen(s.kr, s.mirrored);
    if (s.kr == 0) return seen(s.kt, *s.refracted);
    return seen(s.kr, s.mirrored) + seen(s.kt, *s.refracted);
}
