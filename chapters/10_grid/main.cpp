// Chapter 10: what is the nearest hit? An answer by grid traversal.
//
// Space is divided into equal boxes, and a ray goes from one to the next until it hits something in one (Fujimoto,
// Tanaka and Iwata 1986; Amanatides and Woo 1987). README.md is the lesson; this program makes what it shows.

#include "case_sketches.h"
#include "cases.h"
#include "cell_sizes.h"
#include "grid_facts.h"
#include "pictures.h"
#include "stadium.h"
#include "walk_drawings.h"
#include "walks.h"

#include "raylab/base/lazy.h"
#include "raylab/report/chapter.h"
#include "raylab/report/structure/structure_growth.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::grids;

namespace {

// The way of one ray, in the scene and step by step.
void show_walk(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("scene", [&] { return seen(scene(), run); }, {.keep = Page::Keep::floats});
    page.figure("cells", [&] { return ray_through_cells(scene()); });
    page.table("facts", facts_header(), [&] { return facts_rows(scene()); });
    page.figure("crossings", [] { return draw_crossings(); });
    for (int step = 1; step <= walk_steps; ++step)
        page.figure(fmt::format("grid_step_{}", step), [step] { return draw_walk_step(step); });
    page.figure("hit_beyond", [] { return draw_hit_beyond(); });
}

// Tests and steps over the size of cells, and what mailboxes save.
void show_cost(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    const Lazy<std::vector<CostMap>> tests([&] { return cost_maps(scene(), Cost::primitive_tests, run); });
    const Lazy<std::vector<CostMap>> steps([&] { return cost_maps(scene(), Cost::steps, run); });
    for (std::size_t i = 0; i < std::size(densities); ++i) {
        page.figure(fmt::format("tests_{}", densities[i]), [&] { return heated(tests(), i, Cost::primitive_tests); });
        page.figure(fmt::format("steps_{}", densities[i]), [&] { return heated(steps(), i, Cost::steps); });
    }
    const Lazy<std::vector<DensitySweep>> sweeps([&] { return density_sweeps(run); });
    const auto chart = [&](const std::string& label, double CostPerRay::*cost) {
        return density_chart(sweeps(), label, cost);
    };
    page.figure("density_tests", [&] { return chart("primitive tests a ray", &CostPerRay::tests); });
    page.figure("density_steps", [&] { return chart("cells a ray", &CostPerRay::steps); });
    page.figure("density_bytes", [&] { return chart("bytes a primitive", &CostPerRay::bytes); });
    page.table("densities", density_header(), [&] { return density_rows(sweeps()); });
    page.table("list_lengths", list_length_header(), [&] { return list_length_rows(sweeps().front()); });
    page.table("mailboxes", mailbox_header(), [&] { return mailbox_rows(run); });
}

// A scene for which no size is right, and ever finer ones.
void show_limits(const ChapterRun& run, Page& page) {
    const Lazy<std::shared_ptr<const Scene>> stadium([&] { return stadium_scene(run); });
    page.figure("stadium", [&] { return draw_stadium(*stadium()); });
    page.table("stadium", stadium_header(), [&] { return stadium_rows(stadium(), run); });
    const auto structures = structure_methods({"list", "grid", "grid_mailbox", "bvh"});
    const Lazy<std::vector<StructureCost>> growth([&] { return growth_counts(run, structures); });
    page.figure("growth_tests", [&] { return growth_chart(growth(), GrowthOf::primitive_tests); });
    page.figure("growth_steps", [&] { return growth_chart(growth(), GrowthOf::steps); });
    page.figure("growth_bytes", [&] { return growth_chart(growth(), GrowthOf::bytes); });
}

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    show_walk(run, page, scene);
    show_cost(run, page, scene);
    show_limits(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"10_grid", "The grid", "What is the nearest hit, by walking cells?"},
                          .story = story,
                          .questions = {{"grid_walk", measure_walks}, {"grid_hits", measure_grid_hits}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
