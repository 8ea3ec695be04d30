#pragma once

#include "traced_scene.h"

#include <optional>
#include <span>
#include <vector>

// A node of a traced scene's ray tree as the doubles that are passed from a student's process, which may send anything.

namespace raylab::grading {

inline constexpr std::size_t traced_inputs = 3;    // x and y of the pixel, and the index of a node of its tree
inline constexpr std::size_t traced_outputs = 27;  // the pixel's colour, the number of nodes, the node's fields

/// The student's side: writes one node of a pixel's tree.
void write_traced(const TracedScene& traced, std::span<const double> input, std::span<double> output);

/// The pixel's colour, and the number of nodes of its tree, taken from one node's numbers.
Color traced_color_of(std::span<const double> output);
std::size_t traced_nodes_of(std::span<const double> output);  // 0: the number is not credible

/// The tree from the numbers of all its nodes; absent where they are not those of a tree.
std::optional<RayTree> traced_tree(const TracedScene& traced, std::span<const double> outputs);

}  // namespace raylab::grading
