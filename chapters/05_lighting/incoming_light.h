#pragma once

#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"

namespace raylab::lighting {

/// What arrives at a point of the floor from all directions of the upper half, straight up in the middle and the
/// horizon at the rim, where each light is marked with its name; and beside it all that a local model takes of it:
/// those lights, and one constant for the rest.
Image incoming_light(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::lighting
