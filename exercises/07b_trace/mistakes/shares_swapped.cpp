// hint: shares_swapped
// or: another_question
// Weighs the mirror ray by kt and the refracted one by kr.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
    if (level.depth >= level.limit) return local;
    const double reflected_share = refracted ? kt : kr + kt;
    Vec3d color = local;
    if (reflected_share > 0) color += reflected_share * level.trace(mirrored, level.depth + 1);
    if (refracted && kr > 0) color += kr * level.trace(*refracted, level.depth + 1);
    return color;
}
