// hint: traces_for_nothing
// Traces mirror rays of matt surfaces.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;
    if (level.depth >= level.limit) return s.local;
    const bool total = s.kt > 0 && !s.refracted;
    Vec3d c = s.local + (total ? s.kr + s.kt : s.kr) * level.trace(s.mirrored, level.depth + 1);
    if (s.refracted) c += s.kt * level.trace(*s.refracted, level.depth + 1);
    return c;
}
