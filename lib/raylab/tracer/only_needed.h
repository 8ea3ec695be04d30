#pragma once

#include "raylab/tracer/whitted.h"

namespace raylab {

// What Whitted's recursion is asked for, less what the scene does not need of it (scene/needs.h). The picture stays the
// same to the bit.

/// The scene without the lights of which nothing is seen.
Scene without_unseen_lights(Scene scene, const WhittedOptions& options);

/// No feelers where no light asks for them, no deeper than any ray is worth following.
WhittedOptions only_needed(const Scene& scene, const WhittedOptions& options);

}  // namespace raylab
