// Collects the branches first, and sums over them.
#include "raylab/tracer/traced_color.h"

#include <vector>

namespace {

struct Branch {
    double share;
    raylab::Vec3d direction;
};

std::vector<Branch> branches(const raylab::TracedSurface& surface) {
    if (surface.refracted) return {{surface.kr, surface.mirrored}, {surface.kt, *surface.refracted}};
    return {{surface.kr + surface.kt, surface.mirrored}};
}

}  // namespace

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    Vec3d sum = level.nearest->local;
    for (const auto& [share, direction] : branches(*level.nearest))
        if (share > 0 && level.depth + 1 <= level.limit) sum += share * level.trace(direction, level.depth + 1);
    return sum;
}
