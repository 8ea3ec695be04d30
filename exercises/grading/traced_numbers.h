#pragma once

#include "traced_scene.h"

#include <optional>
#include <span>
#include <vector>

// A node of a traced scene's ray tree as the doubles that cross the pipe from a student's process, which may say
// anything.

namespace raylab::grading {

inline constexpr std::size_t traced_inputs = 3;    // x and y of the pixel, and which node of its tree
inline constexpr std::size_t traced_outputs = 27;  // the pixel's colour, how many nodes there are, the node's fields

/// The student's side: one node of a pixel's tree.
void write_traced(const TracedScene& traced, std::span<const double> input, std::span<double> output);

/// The pixel's colour, and how many nodes its tree has, out of one node's numbers.
Color traced_color_of(std::span<const double> output);
std::size_t traced_nodes_of(std::span<const double> output);  // 0: not to be believed

/// The tree out of the numbers of all its nodes; absent: they are none of a tree.
std::optional<RayTree> traced_tree(const TracedScene& traced, std::span<const double> outputs);

}  // namespace raylab::grading
