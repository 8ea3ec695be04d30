// hint: total_reflection_loses_kt
// Only kr where all is reflected.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest.has_value()) return level.background;
    const TracedSurface& hit = level.nearest.value();
    Vec3d c = hit.local;
    if (level.depth < level.limit) {
        if (hit.kr > 0) c += hit.kr * level.trace(hit.mirrored, level.depth + 1);
        if (hit.kt > 0 && hit.refracted.has_value()) c += hit.kt * level.trace(hit.refracted.value(), level.depth + 1);
    }
    return c;
}
