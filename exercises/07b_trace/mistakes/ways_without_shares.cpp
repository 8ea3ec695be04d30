// hint: shares_forgotten
// Collects the directions in which rays go on, and sums what comes from there. The shares are not collected with them.
#include "raylab/tracer/traced_color.h"

#include <vector>

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& surface = *level.nearest;

    std::vector<Vec3d> ways;
    if (surface.kr > 0 || (surface.kt > 0 && !surface.refracted)) ways.push_back(surface.mirrored);
    if (surface.kt > 0 && surface.refracted) ways.push_back(*surface.refracted);

    Vec3d sum = surface.local;
    for (const Vec3d& way : ways)
        if (level.depth < level.limit) sum += level.trace(way, level.depth + 1);
    return sum;
}
