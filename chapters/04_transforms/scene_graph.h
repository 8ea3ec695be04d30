#pragma once

#include "raylab/report/diagram/diagram.h"
#include "raylab/scene/scene.h"

namespace raylab::transforms {

/// The structure of the scene's file before it is flattened: every group once, an arrow for each of its instances, and
/// the shapes at the ends. It is reconstructed from the paths of the scene's objects.
Diagram scene_graph(const Scene& scene);

}  // namespace raylab::transforms
