#pragma once

#include "raylab/tracer/whitted/ray_tree.h"

#include <span>

namespace raylab {

/// The trees of many samples of a pixel as one, in which rays of one kind to one object are one node: so 64 paths
/// become a diagram that can be read. A node's throughput, colour and contribution are means over all samples;
/// `samples` is the number of those that have it. The root, at depth 0, is the pixel itself; the samples' eye rays are
/// its children. RayTree::pixel is the mean. There is at least one sample.
RayTree folded_tree(std::span<const RayTree> samples);

}  // namespace raylab
