// The shares first, then the rays.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;

    const bool on = level.depth < level.limit;
    const double through = on && s.refracted ? s.kt : 0, mirror = !on ? 0 : s.refracted ? s.kr : s.kr + s.kt;
    Vec3d sum = s.local;
    if (mirror > 0) sum += mirror * level.trace(s.mirrored, level.depth + 1);
    if (through > 0) sum += through * level.trace(*s.refracted, level.depth + 1);
    return sum;
}
