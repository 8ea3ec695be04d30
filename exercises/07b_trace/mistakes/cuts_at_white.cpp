// hint: clamped
// Cuts at white.
#include "raylab/tracer/traced_color.h"

#include <glm/common.hpp>

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;
    Vec3d c = s.local;
    if (level.depth < level.limit) {
        const double kr = s.refracted ? s.kr : s.kr + s.kt;
        if (kr > 0) c += kr * level.trace(s.mirrored, level.depth + 1);
        if (s.kt > 0 && s.refracted) c += s.kt * level.trace(*s.refracted, level.depth + 1);
    }
    return glm::clamp(c, Vec3d(0.0), Vec3d(1.0));
}
