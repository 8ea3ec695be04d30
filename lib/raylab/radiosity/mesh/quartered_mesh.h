#pragma once

#include "raylab/radiosity/mesh/patch_mesh.h"

#include <vector>

namespace raylab {

/// The mesh with each patch that is chosen replaced by its quarters. Patches keep their order, and four stand where one
/// was.
PatchMesh quartered_mesh(PatchMesh mesh, const std::vector<bool>& chosen);

}  // namespace raylab
