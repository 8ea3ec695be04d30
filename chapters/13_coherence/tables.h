#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// Counted work: the same numbers on every machine.

namespace raylab::coherence {

using Rows = std::vector<std::vector<std::string>>;

/// What an item buffer takes and saves as pictures of the ball grow.
std::vector<std::string> saving_header();
Rows saving_rows(const ChapterRun& run);

/// Boxes tested for a ray of the camera, alone and in packets of 8 x 8 pixels, as pixels become smaller.
CurveChart packet_chart(const ChapterRun& run);

/// Feelers of both scenes with and without the memory of what stopped the last one.
std::vector<std::string> memory_header();
Rows memory_rows(const Scene& scene, const ChapterRun& run);

}  // namespace raylab::coherence
