#pragma once

#include "raylab/tracer/whitted/whitted.h"

#include <vector>

namespace raylab {

// The lights and options of Whitted's recursion without those that the scene does not need (scene/needs.h). The picture
// stays the same to the bit.

/// The indices of the lights of which something may be seen.
std::vector<std::size_t> seen_lights(const Scene& scene, const WhittedOptions& options);

/// The scene with the lights of these indices alone, in their order.
Scene with_lights(Scene scene, const std::vector<std::size_t>& numbers);

/// The options with no shadow rays where no light asks for them, and no deeper than any ray is worth following.
WhittedOptions only_needed(const Scene& scene, const WhittedOptions& options);

}  // namespace raylab
