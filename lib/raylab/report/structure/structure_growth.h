#pragma once

#include "raylab/report/chart/chart.h"
#include "raylab/report/chapter.h"
#include "raylab/report/measure.h"
#include "raylab/report/structure/structure_method.h"
#include "raylab/report/structure/structure_workload.h"

#include <string>
#include <vector>

// Cost against size: what a structure takes to be built, to be kept and to be asked as scenes grow.

namespace raylab {

/// One structure at one size.
struct StructureCost {
    std::string structure;
    std::string family;          // of scenes that differ in size only: "bumpy ball"
    std::size_t primitives = 0;
    std::size_t rays = 0;        // how many were traced: fewer where one is dear
    double build_seconds = 0;    // the shortest of some builds
    double bytes = 0;            // a primitive
    Spread nanoseconds = {};     // a ray
    double primitive_tests = 0, box_tests = 0, steps = 0;  // a ray
};

/// Scenes that grow: rays of the same kind through each.
struct GrowingScenes {
    std::string family;
    std::vector<StructureWorkload> workloads;
};

/// A ball with bumps of 20 * 4^level triangles for each level from 2 on; camera rays.
GrowingScenes bumpy_balls(int levels, std::size_t rays);

/// Every structure on every scene. Rays are few enough for the work of each to be at most so many tests, boxes and steps.
std::vector<StructureCost> structure_costs(const std::vector<StructureMethod>& methods, const std::vector<GrowingScenes>& scenes,
                                           double most_work = 4e6, const MeasureOptions& options = {.repeats = 5});

/// What a chart of costs shows.
enum class GrowthOf { rays_per_second, primitive_tests, box_tests, steps, build_time, bytes };

/// A curve for each structure and family, over the number of primitives.
CurveChart growth_chart(const std::vector<StructureCost>& costs, GrowthOf what);

std::vector<std::string> growth_header();
std::vector<std::vector<std::string>> growth_rows(const std::vector<StructureCost>& costs);

/// Measures, writes the charts growth_rays, growth_tests, growth_steps, growth_build and growth_bytes into the chapter's
/// folder, and tells them on its page, with the table: bumpy balls of 5 sizes in a full run; in a quick one of
/// 3, and only the first two charts.
std::vector<StructureCost> tell_growth(const ChapterRun& run, Page& page, const std::vector<StructureMethod>& methods);

}  // namespace raylab
