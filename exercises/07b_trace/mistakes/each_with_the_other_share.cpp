// hint: shares_swapped
// or: another_question
// One lambda brings both rays. Each of them is called with the share of the other.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;

    const auto brought = [&](double share, const Vec3d& way) {
        return share > 0 && level.depth < level.limit ? share * level.trace(way, level.depth + 1) : Vec3d{0, 0, 0};
    };
    if (!s.refracted) return s.local + brought(s.kr + s.kt, s.mirrored);
    return s.local + brought(s.kt, s.mirrored) + brought(s.kr, *s.refracted);
}
