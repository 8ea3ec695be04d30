#pragma once

#include "raylab/report/chapter.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/whitted.h"

#include <map>
#include <string>
#include <vector>

namespace raylab::recursion {

/// The depth of the pictures that count as exact.
inline constexpr int true_depth = 15;

/// "When may the recursion stop?": RMSE of the picture against time per pixel, for depths and for thresholds.
Experiment measure_termination(const ChapterRun& run);

/// The endings of branches, over all pixels of a small picture: in percent of all branches, by the ending's name.
struct Endings {
    std::map<Ending, double> percent;
    double rays_a_pixel = 0;  // without shadow rays
};
Endings endings(const Scene& scene, const WhittedOptions& options, int threads);

}  // namespace raylab::recursion
