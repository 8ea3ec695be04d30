// hint: tinted
// A red mirror shows a red room: what the rays bring is multiplied by the local colour.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    const int next = level.depth + 1;
    if (next > level.limit) return local;
    const double mirror = refracted ? kr : kr + kt;
    Vec3d arriving(0);
    if (mirror > 0) arriving += mirror * level.trace(mirrored, next);
    if (refracted && kt > 0) arriving += kt * level.trace(*refracted, next);
    return local + local * arriving;
}
