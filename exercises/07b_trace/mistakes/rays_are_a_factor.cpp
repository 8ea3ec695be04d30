// hint: tinted
// Sums over the branches how much brighter the surface gets, and multiplies its own colour by that.
#include "raylab/tracer/traced_color.h"

#include <utility>
#include <vector>

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const auto& s = *level.nearest;

    std::vector<std::pair<double, Vec3d>> branches;
    if (level.depth < level.limit) {
        branches.emplace_back(s.refracted ? s.kr : s.kr + s.kt, s.mirrored);
        if (s.refracted) branches.emplace_back(s.kt, *s.refracted);
    }
    Vec3d brightness(1.0);
    for (const auto& [share, direction] : branches)
        if (share > 0) brightness += share * level.trace(direction, level.depth + 1);
    return brightness * s.local;
}
