// One return for each kind of surface.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;

    const int next = level.depth + 1;
    if (next > level.limit || s.kr + s.kt == 0) return s.local;
    if (!s.refracted) return s.local + (s.kr + s.kt) * level.trace(s.mirrored, next);
    const Vec3d seen_through = s.kt > 0 ? s.kt * level.trace(*s.refracted, next) : Vec3d(0.0);
    if (s.kr == 0) return s.local + seen_through;
    return s.local + seen_through + s.kr * level.trace(s.mirrored, next);
}
