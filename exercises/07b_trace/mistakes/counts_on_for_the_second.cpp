// hint: depth_counted_twice
// One variable counts for both rays.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    int depth = level.depth;
    const double reflected_share = refracted ? kr : kr + kt;
    Vec3d color = local;
    if (reflected_share > 0 && depth < level.limit) color += reflected_share * level.trace(mirrored, ++depth);
    if (refracted && kt > 0 && depth < level.limit) color += kt * level.trace(*refracted, ++depth);
    return color;
}
