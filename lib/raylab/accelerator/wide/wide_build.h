#pragma once

#include "raylab/accelerator/wide/wide_node.h"
#include "raylab/geometry/box.h"
#include "raylab/geometry/shapes.h"

#include <span>

namespace raylab {

/// Builds from the top, each node by splitting the largest of its parts until it has eight, where the surface area
/// heuristic over a few bins an axis expects the least work (Wald, On fast Construction of SAH-based Bounding Volume
/// Hierarchies, 2007; Wald, Benthin & Boulos, Getting Rid of Packets, 2008, for many children). Error where there are more
/// than 2^27 primitives.
WideNodes build_wide_nodes(std::span<const Triangle> triangles, std::span<const Box> others);

}  // namespace raylab
