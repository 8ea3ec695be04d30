#pragma once

#include "raylab/radiosity/radiosity_system.h"
#include "raylab/radiosity/visibility.h"

namespace raylab {

/// A solved scene, as pictures of it and estimates of its error take it.
struct RadiosityView {
    const PatchMesh& mesh;
    const PatchVisibility& visibility;
    const Radiosities& patches;   // B of each patch
    const Radiosities& vertices;  // B of each vertex
};

/// B at a place of a patch, interpolated between its vertices (Gouraud).
Color interpolated_radiosity(const RadiosityView& view, const PatchPlace& place);

}  // namespace raylab
