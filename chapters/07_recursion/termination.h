#pragma once

#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted.h"

#include <map>
#include <string>
#include <vector>

namespace raylab::recursion {

/// Where the truth stops.
inline constexpr int true_depth = 15;

/// "When may the recursion stop?": RMSE of the picture against time a pixel, for depths and for thresholds.
Experiment measure_termination(const ChapterRun& run);

/// How branches end, over all pixels of a small picture: in percent of all branches, by the word of the ending.
struct Endings {
    std::map<Ending, double> percent;
    double rays_a_pixel = 0;  // shadow feelers apart
};
Endings endings(const Scene& scene, const WhittedOptions& options, int threads);

}  // namespace raylab::recursion
