#include "raylab/tracer/only_needed.h"

#include "raylab/scene/needs.h"

#include <algorithm>

namespace raylab {

namespace {

// Feelers that start carelessly also find shadows where there are none, and who asked for those wants to see them.
bool start_surely(const RayStart& start) {
    return start.offset == RayStart::Offset::error_bounded && start.leaving == RayStart::Leaving::known;
}

}  // namespace

WhittedOptions only_needed(const Scene& scene, const WhittedOptions& options) {
    using Split = NeedsOptions::Split;
    const bool by_angle = options.reflectance == WhittedOptions::Reflectance::fresnel;
    const Needs needs = needs_of(scene, {.threshold = options.threshold,
                                         .depth_limit = options.depth,
                                         .split = by_angle ? Split::by_angle : Split::as_given});
    WhittedOptions reduced = options;
    reduced.depth = needs.depth;
    if (!needs.shadows && start_surely(options.start)) reduced.shadows = WhittedOptions::Shadows::none;
    return reduced;
}

}  // namespace raylab
