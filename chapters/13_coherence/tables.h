#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// Counts of work, which are the same on every machine.

namespace raylab::coherence {

using Rows = std::vector<std::vector<std::string>>;

/// The costs and savings of an item buffer as pictures of the sphere grow.
std::vector<std::string> saving_header();
Rows saving_rows(const ChapterRun& run);

/// Box tests for each camera ray, alone and in packets of 8 x 8 pixels, as pixels become smaller.
CurveChart packet_chart(const ChapterRun& run);

/// Shadow rays of both scenes with and without the memory of the last blocker.
std::vector<std::string> memory_header();
Rows memory_rows(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::coherence
