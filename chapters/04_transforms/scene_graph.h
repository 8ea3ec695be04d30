#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/scene/scene.h"

namespace raylab::transforms {

/// What the scene's file says before it is flattened: every group once, an arrow for each time it is placed, and the
/// shapes at the ends. Read from the paths of the scene's objects.
Diagram scene_graph(const Scene& scene);

}  // namespace raylab::transforms
