// hint: each_ray_by_itself
// What does not mirror is taken for matt.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    if (kr == 0 || level.depth >= level.limit) return local;
    Vec3d color = local + (refracted ? kr : kr + kt) * level.trace(mirrored, level.depth + 1);
    if (refracted && kt > 0) color += kt * level.trace(*refracted, level.depth + 1);
    return color;
}
