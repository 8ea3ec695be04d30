// hint: black_at_the_limit
// Black at the limit.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    if (level.depth >= level.limit) return {0, 0, 0};
    const auto& s = *level.nearest;
    Vec3d c = s.local;
    const double kr = s.refracted ? s.kr : s.kr + s.kt;
    if (kr > 0) c += kr * level.trace(s.mirrored, level.depth + 1);
    if (s.kt > 0 && s.refracted) c += s.kt * level.trace(*s.refracted, level.depth + 1);
    return c;
}
