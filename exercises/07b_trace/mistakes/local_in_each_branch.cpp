// hint: local_twice
// Adds the local colour once for every ray.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    if (level.depth >= level.limit) return local;
    const double reflected_share = refracted ? kr : kr + kt;
    Vec3d color{0, 0, 0};
    if (reflected_share > 0) color += local + reflected_share * level.trace(mirrored, level.depth + 1);
    if (refracted && kt > 0) color += local + kt * level.trace(*refracted, level.depth + 1);
    return reflected_share > 0 || (refracted && kt > 0) ? color : local;
}
