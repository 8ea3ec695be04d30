// hint: what_is_left
// Divides both shares by their sum.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    const int next = level.depth + 1;
    if (next > level.limit) return local;
    const double mirror = refracted ? kr : kr + kt;
    const double all = kr + kt;
    Vec3d sum = local;
    if (mirror > 0) sum += mirror / all * level.trace(mirrored, next);
    if (refracted && kt > 0) sum += kt / all * level.trace(*refracted, next);
    return sum;
}
