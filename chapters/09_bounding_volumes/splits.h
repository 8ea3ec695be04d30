#pragma once

#include "split_scenes.h"

#include "raylab/report/chart/chart.h"

#include <span>
#include <string>
#include <vector>

// Do spatial splits pay? Trees of boxes that may split their primitives, beside those that may not.

namespace raylab::volumes {

/// A ray's work in each scene and tree.
std::vector<std::string> splits_header();
std::vector<std::vector<std::string>> splits_rows(std::span<const SplitScene> scenes);

/// The share of the work that is left for each permitted share of duplicates, against the memory that they take.
CurveChart splits_chart(std::span<const SplitScene> scenes);

}  // namespace raylab::volumes
