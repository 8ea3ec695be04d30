// hint: one_ray_only
// Glass lets through or mirrors.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;
    if (level.depth >= level.limit) return s.local;
    if (s.kt > 0 && s.refracted) return s.local + s.kt * level.trace(*s.refracted, level.depth + 1);
    if (s.kr + s.kt > 0) return s.local + (s.kr + s.kt) * level.trace(s.mirrored, level.depth + 1);
    return s.local;
}
