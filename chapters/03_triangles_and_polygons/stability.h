#pragma once

#include "raylab/report/chapter.h"
#include "raylab/report/stability.h"

#include <vector>

// Ten named cases in which some ray-triangle methods fail, and others hold.

namespace raylab {

/// The method that is never wrong.
inline constexpr auto filtered_exact = "filtered exact, double + exact";

std::vector<StabilityCase> stability_cases(const ChapterRun& run);

// Each subject has a file of its own.
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
