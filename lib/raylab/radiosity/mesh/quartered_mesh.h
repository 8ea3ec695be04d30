#pragma once

#include "raylab/radiosity/mesh/patch_mesh.h"

#include <vector>

namespace raylab {

/// The mesh with each patch that is chosen replaced by its quarters. Patches keep their order, and four stand where one
/// was; so does what is known of each patch, by with_quarters().
PatchMesh quartered_mesh(PatchMesh mesh, const std::vector<bool>& chosen);

/// A value of each patch for each patch of the quartered mesh: a quarter's is that of the whole.
template <class Value>
std::vector<Value> with_quarters(const std::vector<Value>& values, const std::vector<bool>& chosen) {
    std::vector<Value> result;
    for (std::size_t i = 0; i < values.size(); ++i) result.insert(result.end(), chosen[i] ? 4 : 1, values[i]);
    return result;
}

}  // namespace raylab
