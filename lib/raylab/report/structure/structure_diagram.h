#pragma once

#include "raylab/accelerator/outline.h"
#include "raylab/report/diagram/diagram.h"

#include <span>
#include <string>

namespace raylab {

/// The part of a structure that a diagram shows.
struct StructureDiagramView {
    std::size_t largest = 40;            // the number of nodes, from the root on; those below are summed up in words
    std::span<const Visit> visits = {};  // of a ray: these nodes are numbered in this order, and drawn thick
};

/// A structure as a tree: inner nodes are round, leaves are boxes with their primitives, empty leaves are dashed. The
/// cells of a grid are its root's children.
Diagram structure_diagram(const Outline& outline, const std::string& title, const StructureDiagramView& view = {});

}  // namespace raylab
