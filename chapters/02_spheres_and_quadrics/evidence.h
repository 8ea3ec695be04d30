#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"

#include <string>
#include <vector>

// The chapter's tables and its curve: all measurements other than speed against accuracy.

namespace raylab {

using Rows = std::vector<std::vector<std::string>>;

/// b^2, a c and their difference for two rays past a sphere 4096 radii away, in float and in double.
std::vector<std::string> cancellation_header();
Rows cancellation_rows();

/// The angles between gradient normals and the exact ones, and the lengths of gradients, by the kind of quadric.
std::vector<std::string> normal_header();
Rows normal_rows(const ChapterRun& run);

/// Misses and false hits in ppm of every method on every workload.
std::vector<std::string> decisions_header(const ChapterRun& run);
Rows decisions_rows(const ChapterRun& run);

/// Wrong decisions over the distance to a sphere, in radii.
CurveChart wrong_by_distance(const ChapterRun& run);

}  // namespace raylab
