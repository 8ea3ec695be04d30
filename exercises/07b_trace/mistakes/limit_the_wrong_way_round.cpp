// hint: no_ray_goes_on
// Ends where rays should go on.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    if (level.depth < level.limit) return local;
    const double reflected_share = refracted ? kr : kr + kt;
    Vec3d color = local;
    if (reflected_share > 0) color += reflected_share * level.trace(mirrored, level.depth + 1);
    if (refracted && kt > 0) color += kt * level.trace(*refracted, level.depth + 1);
    return color;
}
