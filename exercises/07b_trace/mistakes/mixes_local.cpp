// hint: local_dimmed
// Mixes, as a blend would.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;
    if (level.depth >= level.limit) return s.local;
    const double kr = s.refracted ? s.kr : s.kr + s.kt, kt = s.refracted ? s.kt : 0;
    Vec3d c = (1 - kr - kt) * s.local;
    if (kr > 0) c += kr * level.trace(s.mirrored, level.depth + 1);
    if (kt > 0) c += kt * level.trace(*s.refracted, level.depth + 1);
    return c;
}
