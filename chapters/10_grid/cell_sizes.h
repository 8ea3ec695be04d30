#pragma once

#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/report/chapter_run.h"
#include "raylab/report/chart/chart.h"
#include "raylab/scene/scene.h"

#include <memory>
#include <string>
#include <vector>

// How large should a cell be?

namespace raylab::grids {

/// The cost of one structure for a ray.
struct CostPerRay {
    double tests = 0, box_tests = 0, steps = 0;
    double bytes = 0;  // for each primitive
};
CostPerRay cost_per_ray(const std::string& accelerator, const StructureWorkload& workload);

std::shared_ptr<const Scene> knot(const ChapterRun& run);

/// The costs of grids in one scene over the density of cells.
struct DensitySweep {
    std::string scene;
    std::vector<double> densities;
    std::vector<CostPerRay> costs;
};

/// Even balls, the knot, and the knot in a stadium.
std::vector<DensitySweep> density_sweeps(const ChapterRun& run);

/// A curve for each scene of this cost.
CurveChart density_chart(const std::vector<DensitySweep>& sweeps, const std::string& label, double CostPerRay::*cost);

std::vector<std::string> density_header();
std::vector<std::vector<std::string>> density_rows(const std::vector<DensitySweep>& sweeps);

/// Tests in each cell that a ray visits among even balls: counted, and by Steiner's formula.
std::vector<std::string> list_length_header();
std::vector<std::vector<std::string>> list_length_rows(const DensitySweep& even_balls);

/// The savings by both kinds of mailboxes.
std::vector<std::string> mailbox_header();
std::vector<std::vector<std::string>> mailbox_rows(const ChapterRun& run);

}  // namespace raylab::grids
