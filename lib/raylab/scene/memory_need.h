#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/scene.h"

namespace raylab {

/// The most memory that the default accelerator over the scene takes while it is built, and a picture of this size.
/// A mesh that stands at several places counts once, because its instances share the hierarchy over it; where it moves,
/// or stands where it was made, it counts with all its triangles each time.
MemoryNeed picture_need(const Scene& scene, ImageSize image);

/// The memory of the accelerator alone.
MemoryNeed accelerator_need(const Scene& scene);
MemoryNeed accelerator_need(const Mesh& mesh);

}  // namespace raylab
