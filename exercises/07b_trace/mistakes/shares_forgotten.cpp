// hint: shares_forgotten
// Adds what the rays bring whole.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    if (level.depth >= level.limit) return local;
    Vec3d color = local;
    if (kr > 0 || (kt > 0 && !refracted)) color += level.trace(mirrored, level.depth + 1);
    if (refracted && kt > 0) color += level.trace(*refracted, level.depth + 1);
    return color;
}
