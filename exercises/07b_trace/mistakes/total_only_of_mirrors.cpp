// hint: total_reflection_loses_kt
// Glass that mirrors nothing traces no ray, not even under total internal reflection.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    if (level.depth >= level.limit) return local;
    Vec3d sum = local;
    if (kr > 0) sum += (refracted ? kr : kr + kt) * level.trace(mirrored, level.depth + 1);
    if (refracted && kt > 0) sum += kt * level.trace(*refracted, level.depth + 1);
    return sum;
}
