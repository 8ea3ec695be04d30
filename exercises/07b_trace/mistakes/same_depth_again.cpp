// hint: depth_not_counted
// The depth is handed on as it came.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;
    Vec3d sum = s.local;
    if (level.depth == level.limit) return sum;
    const double kr = s.kr + (s.kt > 0 && !s.refracted ? s.kt : 0);
    if (kr > 0) sum += kr * level.trace(s.mirrored, level.depth);
    if (s.kt > 0 && s.refracted) sum += s.kt * level.trace(*s.refracted, level.depth);
    return sum;
}
