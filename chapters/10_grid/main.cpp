// Chapter 10: what is the nearest hit? An answer by grid traversal.
//
// Space is divided into equal boxes, and a ray goes from one to the next until it hits something in one (Fujimoto,
// Tanaka and Iwata 1986; Amanatides and Woo 1987). The formulas are in README.md, which tells the same story.

#include "cases.h"
#include "cell_sizes.h"
#include "grid_facts.h"
#include "pictures.h"
#include "walks.h"

#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/report/structure/structure_growth.h"
#include "raylab/report/structure/structure_portraits.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::grids;

namespace {

// 1. The scene, and the way of one ray through it: README (1), (2).
void tell_walk(const ChapterRun& run, Page& page, const Scene& scene) {
    const GridFacts grid = grid_facts(scene);
    page.heading("Walking cells");
    page.text("The grid lists in each cell what reaches into it. A ray visits the cells on its way, near to far, "
              "and tests what they list. A hit *inside the cell* ends the walk: everything behind is farther.");
    page.figures({{write_picture(seen(scene, run), run.out, "scene"), "What is looked at."},
                  {write_picture(ray_through_cells(scene), run.out, "cells"),
                   "One ray. Numbers: the order of its cells; bold: what is tested there."}});
    page.text(fmt::format("{} primitives, {} x {} x {} cells, {} "
                          "entries in their lists.",
                          grid.primitives, grid.along[0], grid.along[1], grid.along[2], grid.entries));
}

// 2. The costs, and where they arise: README "Tests and steps".
void tell_cost(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Tests and steps");
    page.text("Two things cost: primitives tested, and cells visited on the way to them. One grows where the other "
              "shrinks.");
    page.figures({{write_picture(tests_a_pixel(scene, run), run.out, "tests"),
                   "Cells 1, 8 and 64 times as many as primitives: fewer tests ..."},
                  {write_picture(cells_a_pixel(scene, run), run.out, "steps"), "... for more cells."}});
    page.text("With mailboxes and without: the same cells, and the same way; only tests are fewer.");
    const auto grids = structure_methods({"grid", "grid_mailbox"});
    tell_portraits(run, page, grids, scene, ray_over_the_table, {.along = 1});
    page.figures({{write_picture(tests_of_each(run, grids, scene), run.out, "tests_of_each"),
                   "Tests for each pixel, in the same colours."}});
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_walk(run, page, scene);
    tell_cost(run, page, scene);
    tell_cell_sizes(run, page);
    tell_mailboxes(run, page);
    tell_stadium(run, page);
    page.heading("As scenes grow");
    page.text("A ball, ever finer: a list's cost is its length, a grid's the cube root of it.");
    tell_growth(run, page, structure_methods({"list", "grid", "grid_mailbox", "bvh"}));
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"10_grid", "The grid", "What is the nearest hit, by walking cells?"},
                          .story = story,
                          .questions = {{"grid_walk", measure_walks}, {"grid_hits", measure_grid_hits}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
