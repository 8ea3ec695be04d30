#pragma once

#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The chapter's tables.

namespace raylab::recursion {

using Rows = std::vector<std::vector<std::string>>;

/// Why branches end at three settings of depth and threshold, over all pixels of a small picture.
std::vector<std::string> endings_header();
Rows endings_rows(const Scene& scene, int threads);

/// The brightness of a hall of mirrors with rho = 0.5 and 0.9 at several depths, and in closed form.
Rows hall_of_mirrors_rows();

}  // namespace raylab::recursion
