#pragma once

#include "raylab/radiosity/hierarchy/element_tree.h"

#include <cstdint>
#include <vector>

namespace raylab {

/// The leaves of a hierarchy as the patches of a mesh, and the number of each patch's element.
struct LeafMesh {
    PatchMesh mesh;
    std::vector<std::uint32_t> elements;
};

/// `roots` is the mesh whose patches are the tree's roots.
LeafMesh leaf_mesh(PatchMesh roots, const ElementTree& elements);

/// The values of leaves, in the order of the mesh's patches.
template <class Value>
std::vector<Value> of_leaves(const std::vector<Value>& values, const LeafMesh& leaves) {
    std::vector<Value> result;
    for (const std::uint32_t element : leaves.elements) result.push_back(values[element]);
    return result;
}

}  // namespace raylab
