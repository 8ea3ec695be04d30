// hint: traced_twice
// Under total internal reflection the mirror ray is traced for kr and again for kt.
#include "raylab/tracer/traced_color.h"

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& s = *level.nearest;
    if (level.depth == level.limit) return s.local;
    const auto seen = [&](double share, const Vec3d& direction) {
        return share > 0 ? share * level.trace(direction, level.depth + 1) : Vec3d{0, 0, 0};
    };
    const Vec3d mirror = seen(s.kr, s.mirrored);
    return s.local + mirror + seen(s.kt, s.refracted.value_or(s.mirrored));
}
