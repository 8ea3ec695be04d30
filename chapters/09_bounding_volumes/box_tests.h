#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/experiment/measure/wrong_decisions.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/report/chapter.h"

#include <optional>
#include <string>
#include <vector>

// "Does this ray hit that box, and from which t on?": the methods, their queries, and their charts.

namespace raylab::volumes {

struct BoxQuery {
    Ray ray;
    std::uint32_t box;
};
using BoxMethod = Method<Box, BoxQuery, std::optional<double>>;
using BoxWorkload = Workload<Box, BoxQuery>;

/// The slab test in its variants, the lab's own in doubles and, four boxes at a time, in floats; and the slot of
/// exercise 09.
std::vector<BoxMethod> box_methods(const ChapterRun& run);

/// "random", "at edges", "at corners", "at corners, far", "in a plane", "flat boxes", with this many queries each.
std::vector<BoxWorkload> box_workloads(std::size_t queries, std::uint64_t seed);

Truth box_truth(const BoxWorkload& workload, int threads);

/// For each method, how many of a million boxes that are hit it misses, with a column for each workload.
std::vector<std::string> missed_header();
std::vector<std::vector<std::string>> missed_rows(const ChapterRun& run);

Experiment measure_ray_box(const ChapterRun& run);

}  // namespace raylab::volumes
