// hint: kt_twice
// The mirror ray has kr + kt, whether or not something is refracted.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    if (level.depth >= level.limit) return local;
    Vec3d color = local;
    if (kr + kt > 0) color += (kr + kt) * level.trace(mirrored, level.depth + 1);
    if (refracted && kt > 0) color += kt * level.trace(*refracted, level.depth + 1);
    return color;
}
