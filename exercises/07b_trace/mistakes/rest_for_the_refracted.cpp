// hint: what_is_left
// The refracted ray has the share 1 - kr, as if nothing were lost.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& s = *level.nearest;
    if (level.depth + 1 > level.limit) return s.local;
    const bool is_total = s.kt > 0 && !s.refracted;
    const double mirror = is_total ? s.kr + s.kt : s.kr;
    Vec3d sum = s.local;
    if (mirror > 0) sum += mirror * level.trace(s.mirrored, level.depth + 1);
    if (s.kt > 0 && !is_total) sum += (1 - s.kr) * level.trace(*s.refracted, level.depth + 1);
    return sum;
}
