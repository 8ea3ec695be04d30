// hint: one_ray_only
// Chooses the direction in which the ray goes on, as if there were one only.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& surface = *level.nearest;

    Vec3d way = surface.mirrored;
    double share = surface.kr + surface.kt;
    if (surface.kt > 0 && surface.refracted) {
        way = *surface.refracted;
        share = surface.kt;
    }
    const bool goes_on = share > 0 && level.depth + 1 <= level.limit;
    return goes_on ? surface.local + share * level.trace(way, level.depth + 1) : surface.local;
}
