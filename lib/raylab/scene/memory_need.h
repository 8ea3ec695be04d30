#pragma once

#include "raylab/base/memory_limit.h"
#include "raylab/scene/scene.h"

namespace raylab {

/// What the default accelerator over the scene takes at most, while it is built, and a picture of this size. Every
/// instance of a mesh counts with all its triangles: instances share the mesh, but not the hierarchy above it.
MemoryNeed picture_need(const Scene& scene, ImageSize image);

/// The same without a picture.
MemoryNeed accelerator_need(const Scene& scene);
MemoryNeed accelerator_need(const Mesh& mesh);

}  // namespace raylab
