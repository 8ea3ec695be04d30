#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/scene/scene.h"

namespace raylab {

/// The box about all objects that have bounds; empty where none has.
Box scene_bounds(const Scene& scene);

}  // namespace raylab
