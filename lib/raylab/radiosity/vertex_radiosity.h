#pragma once

#include "raylab/radiosity/mesh/patch_mesh.h"
#include "raylab/radiosity/radiosity_system.h"

namespace raylab {

/// What a vertex gets that lies on the side of a larger patch.
enum class TVertices {
    mended,  // the mean of the side's ends, as that patch shows it there: the picture has no crack
    left,    // what its own patches say
};

/// The radiosities of PatchMesh::vertices, from those of the patches. A vertex with patches all around it is their
/// mean. One on a border takes what makes the mean of it and its nearest inner vertex the mean of its own patches, so
/// that a gradient goes on to the border; where that would be negative it is 0, and where there is no inner vertex it
/// is its patches' mean. (Cohen and Greenberg, The Hemi-Cube, SIGGRAPH 85.)
Radiosities vertex_radiosities(const PatchMesh& mesh, const Radiosities& patches,
                               TVertices treatment = TVertices::mended);

}  // namespace raylab
