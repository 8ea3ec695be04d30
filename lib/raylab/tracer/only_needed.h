#pragma once

#include "raylab/tracer/whitted.h"

namespace raylab {

/// What Whitted's recursion is asked for, less what the scene does not need of it: no feelers where no light asks for
/// them, no deeper than any ray is worth following. The picture stays the same.
WhittedOptions only_needed(const Scene& scene, const WhittedOptions& options);

}  // namespace raylab
