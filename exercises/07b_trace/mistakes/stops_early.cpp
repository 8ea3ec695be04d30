// hint: one_level_short
// Stops one level early.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;
    Vec3d sum = s.local;
    if (level.depth + 1 >= level.limit) return sum;
    const double kr = s.kr + (s.kt > 0 && !s.refracted ? s.kt : 0);
    if (kr > 0) sum += kr * level.trace(s.mirrored, level.depth + 1);
    if (s.kt > 0 && s.refracted) sum += s.kt * level.trace(*s.refracted, level.depth + 1);
    return sum;
}
