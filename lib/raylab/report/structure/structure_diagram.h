#pragma once

#include "raylab/accelerator/outline.h"
#include "raylab/report/diagram/diagram.h"

#include <span>
#include <string>

namespace raylab {

/// How much of a structure a diagram shows.
struct StructureDiagramView {
    std::size_t most = 40;              // nodes, the upper ones; what lies below is told in a word
    std::span<const Visit> visits = {};  // of a ray: these nodes are numbered in this order, and thick
};

/// A structure as a tree: inner nodes round, leaves as boxes with their primitives, empty ones dashed. A grid's cells are
/// its root's children.
Diagram structure_diagram(const Outline& outline, const std::string& title, const StructureDiagramView& view = {});

}  // namespace raylab
