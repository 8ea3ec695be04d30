// hint: background_forgotten
// Black where nothing is hit.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest.has_value()) return Vec3d(0.0);
    const TracedSurface& hit = level.nearest.value();
    Vec3d c = hit.local;
    if (level.depth < level.limit) {
        const bool total = hit.kt > 0 && !hit.refracted;
        const double share = total ? hit.kr + hit.kt : hit.kr;
        if (share > 0) c += share * level.trace(hit.mirrored, level.depth + 1);
        if (hit.kt > 0 && !total) c += hit.kt * level.trace(*hit.refracted, level.depth + 1);
    }
    return c;
}
