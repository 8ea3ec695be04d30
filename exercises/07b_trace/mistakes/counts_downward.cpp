// hint: counts_downward
// Takes the depth for the number of levels that are left.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& s = *level.nearest;
    const int left = level.depth - 1;
    if (left < 0) return s.local;
    const double mirror = s.kt > 0 && !s.refracted ? s.kr + s.kt : s.kr;
    Vec3d sum = s.local;
    if (mirror > 0) sum += mirror * level.trace(s.mirrored, left);
    if (s.kt > 0 && s.refracted) sum += s.kt * level.trace(*s.refracted, left);
    return sum;
}
