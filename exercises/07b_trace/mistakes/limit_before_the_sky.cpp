// hint: background_forgotten
// Asks for the limit first, and there is black where nothing was hit.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    const bool is_last = level.depth >= level.limit;
    if (is_last) return level.nearest ? level.nearest->local : Vec3d{0, 0, 0};
    if (!level.nearest) return level.background;
    const TracedSurface& s = *level.nearest;
    const double mirror = s.kt > 0 && !s.refracted ? s.kr + s.kt : s.kr;
    Vec3d sum = s.local;
    if (mirror > 0) sum += mirror * level.trace(s.mirrored, level.depth + 1);
    if (s.kt > 0 && s.refracted) sum += s.kt * level.trace(*s.refracted, level.depth + 1);
    return sum;
}
