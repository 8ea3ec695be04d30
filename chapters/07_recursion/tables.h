#pragma once

#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/ray_tree.h"

#include <string>
#include <vector>

// The chapter's tables.

namespace raylab::recursion {

using Rows = std::vector<std::vector<std::string>>;

/// The sum of a tree: for every ray that was cast, shadow rays aside, its throughput, I_local, and their product; then
/// the pixel.
std::vector<std::string> ray_sum_header();
Rows ray_sum_rows(const Scene& scene, const RayTree& tree);

/// The reflected and the refracted direction at the first hit of the section's ray, step by step: x and y.
Rows worked_refraction_rows();

/// Why branches end at three settings of depth and threshold, over all pixels of a small picture.
std::vector<std::string> endings_header();
Rows endings_rows(const Scene& scene, int threads);

/// The brightness of a hall of mirrors with rho = 0.5 and 0.9 at several depths, and in closed form.
Rows hall_of_mirrors_rows();

}  // namespace raylab::recursion
