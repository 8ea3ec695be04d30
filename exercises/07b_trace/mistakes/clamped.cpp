// hint: clamped
// Clamps what it returns to 1, as a screen would.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    const double reflected_share = refracted ? kr : kr + kt;
    Vec3d color = local;
    if (level.depth < level.limit && reflected_share > 0)
        color += reflected_share * level.trace(mirrored, level.depth + 1);
    if (level.depth < level.limit && refracted && kt > 0) color += kt * level.trace(*refracted, level.depth + 1);
    return {color.x < 1 ? color.x : 1, color.y < 1 ? color.y : 1, color.z < 1 ? color.z : 1};
}
