// hint: depth_of_its_own
// A counter of calls that are not over yet stands for the depth that is given.
#include "raylab/tracer/traced_color.h"

namespace {

int open_calls = 0;

}  // namespace

raylab::Vec3d raylab::traced_color(const TracedLevel& level) {
    if (!level.nearest) return level.background;
    const TracedSurface& surface = *level.nearest;
    const double mirror = surface.refracted ? surface.kr : surface.kr + surface.kt;
    Vec3d sum = surface.local;
    ++open_calls;
    if (open_calls < level.limit) {
        if (mirror > 0) sum += mirror * level.trace(surface.mirrored, open_calls + 1);
        if (surface.refracted && surface.kt > 0) sum += surface.kt * level.trace(*surface.refracted, open_calls + 1);
    }
    --open_calls;
    return sum;
}
