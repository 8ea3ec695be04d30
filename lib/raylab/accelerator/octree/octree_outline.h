#pragma once

#include "raylab/accelerator/octree/octree_cells.h"
#include "raylab/accelerator/outline.h"

namespace raylab {

/// The outline of an octree for diagrams: its leaves name places[i] for box i.
Outline outline_of(const Lattice& lattice, const OctreeCells& tree, std::span<const std::uint32_t> places);

}  // namespace raylab
