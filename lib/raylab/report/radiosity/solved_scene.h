#pragma once

#include "raylab/radiosity/mesh/patch_mesh.h"
#include "raylab/radiosity/radiosity_system.h"

#include <vector>

namespace raylab {

/// A scene whose radiosities are known, as the writers of tables and models take it.
struct SolvedScene {
    const PatchMesh& mesh;
    const std::vector<Color>& reflectance;
    const Radiosities& patches;   // B of each patch
    const Radiosities& vertices;  // B of each vertex of the mesh
};

}  // namespace raylab
