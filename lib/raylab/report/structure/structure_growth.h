#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/experiment/structure/structure_method.h"
#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"

#include <string>
#include <vector>

// Cost against size: the time to build a structure, its memory and the time of its queries as scenes grow.

namespace raylab {

/// The cost of one structure at one size.
struct StructureCost {
    std::string structure;
    std::string family;  // the name of scenes that differ in size only: "bumpy ball"
    std::size_t primitives = 0;
    std::size_t rays = 0;                                  // how many were traced: fewer where each is expensive
    double build_seconds = 0;                              // the shortest of several builds
    double bytes = 0;                                      // for each primitive
    Spread nanoseconds = {};                               // for each ray
    double primitive_tests = 0, box_tests = 0, steps = 0;  // for each ray
};

/// Scenes of growing size, with rays of the same kind through each.
struct GrowingScenes {
    std::string family;
    std::vector<StructureWorkload> workloads;
};

/// Balls with bumps, of 20 * 4^level triangles for each level from 2 on, with camera rays.
GrowingScenes bumpy_balls(int levels, std::size_t rays);

/// Measures every structure on every scene. The number of rays is limited so that the tests, boxes and steps of each
/// measurement are at most the given number.
std::vector<StructureCost> structure_costs(const std::vector<StructureMethod>& methods,
                                           const std::vector<GrowingScenes>& scenes, double max_work = 4e6,
                                           const MeasureOptions& options = {.repeats = 5});

/// What ever finer bumpy balls cost: 5 sizes in a full run, 3 in a quick one. Their times are hardly measured; the
/// counts are the same on every machine.
std::vector<StructureCost> growth_counts(const ChapterRun& run, const std::vector<StructureMethod>& methods);

/// The quantity that a chart of costs shows.
enum class GrowthOf { rays_per_second, primitive_tests, box_tests, steps, build_time, bytes };

/// A curve for each structure and family, over the number of primitives.
CurveChart growth_chart(const std::vector<StructureCost>& costs, GrowthOf what);

}  // namespace raylab
