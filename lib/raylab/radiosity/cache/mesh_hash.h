#pragma once

#include "raylab/radiosity/cache/content_hash.h"
#include "raylab/radiosity/mesh/patch_mesh.h"

namespace raylab {

/// Adds all that form factors depend on: the patches, and what hides them, polygons without patches too.
void add_geometry(ContentHash& hash, const PatchMesh& mesh);

}  // namespace raylab
