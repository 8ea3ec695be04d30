#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/scene.h"

namespace raylab {

/// The most memory that the default accelerator over the scene takes while it is built, and a picture of this size.
/// Every instance of a mesh counts with all its triangles, because instances share the mesh but not the hierarchy over
/// it.
MemoryNeed picture_need(const Scene& scene, ImageSize image);

/// The memory of the accelerator alone.
MemoryNeed accelerator_need(const Scene& scene);
MemoryNeed accelerator_need(const Mesh& mesh);

}  // namespace raylab
