// hint: kt_twice
// The refracted ray first. What glass has is added to the mirror's share before it is asked whether all is reflected.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& surface = *level.nearest;
    const int next = level.depth + 1;
    if (next > level.limit) return surface.local;

    Vec3d transmitted{0, 0, 0}, reflected{0, 0, 0};
    double mirror = surface.kr;
    if (surface.kt > 0) {
        mirror += surface.kt;
        if (surface.refracted) transmitted = level.trace(*surface.refracted, next);
    }
    if (mirror > 0) reflected = level.trace(surface.mirrored, next);
    return surface.local + mirror * reflected + surface.kt * transmitted;
}
