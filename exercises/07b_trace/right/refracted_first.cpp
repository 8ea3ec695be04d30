// One case after the other, the refracted ray before the mirror ray.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& surface = *level.nearest;
    const int next = level.depth + 1;
    if (next > level.limit) return surface.local;

    Vec3d transmitted{0, 0, 0}, reflected{0, 0, 0};
    double mirror = surface.kr;
    if (surface.kt > 0) {
        if (surface.refracted)
            transmitted = level.trace(*surface.refracted, next);
        else
            mirror = surface.kr + surface.kt;  // total internal reflection
    }
    if (mirror > 0) reflected = level.trace(surface.mirrored, next);
    return surface.local + mirror * reflected + surface.kt * transmitted;
}
