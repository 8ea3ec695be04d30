#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/stability.h"

#include <vector>

// Where ray-triangle methods fail, and where others hold: ten named cases.

namespace raylab {

std::vector<StabilityCase> stability_cases(const ChapterRun& run);

// By subject, each in a file of its own.
StabilityCase edge_shot(const ChapterRun& run);
StabilityCase vertex_shot(const ChapterRun& run);
StabilityCase fma_switch(const ChapterRun& run);
StabilityCase det_eps(const ChapterRun& run);
StabilityCase sliver(const ChapterRun& run);
StabilityCase far_scene(const ChapterRun& run);
StabilityCase range(const ChapterRun& run);
StabilityCase lattice(const ChapterRun& run);
StabilityCase double_input(const ChapterRun& run);
StabilityCase epick_ray(const ChapterRun& run);

}  // namespace raylab
