// Chapter 11: where does a ray go on, if cells are of all sizes? README.md is the lesson; here is what it shows.

#include "case_sketches.h"
#include "cases.h"
#include "next_cell_drawings.h"
#include "octree_methods.h"
#include "octree_workloads.h"
#include "pictures.h"

#include "raylab/base/lazy.h"
#include "raylab/report/chapter.h"
#include "raylab/report/structure/structure_growth.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::octrees;

namespace {

// Eight equal children.
void show_tree(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    page.figure("cells", [&] { return cells_in_picture(scene(), run); });
    for (int cuts = 1; cuts <= 6; ++cuts)
        page.figure("cuts_" + std::to_string(cuts), [&, cuts] { return draw_cuts(scene(), cuts); });
    page.table("cuts", cuts_header(), [&] { return cuts_rows(scene()); });
    page.figure("way", [&] { return draw_way(scene()); });
}

// Where rays cost most, in pictures of the hall: a map for each structure, all in the same colours.
class CostPictures {
public:
    CostPictures(const ChapterRun& run, Cost cost, std::vector<std::string> names)
        : names_(std::move(names)), maps_([=, this] {
              const auto scene = hall(run.sized(5, 4));
              const int side = run.sized(640, 150);
              const CameraFrame frame = camera_frame(scene->camera, {side, side}, "hall");
              std::vector<CostMap> maps;
              for (const std::string& name : names_)
                  maps.push_back(cost_map(*make_accelerator(name, *scene), frame, cost, run.threads));
              return maps;
          }) {}

    void show(Page& page, const std::string& what, const std::string& title) const {
        for (std::size_t i = 0; i < names_.size(); ++i)
            page.figure(what + "_of_" + names_[i],
                        [&, i] { return heat_map(maps_()[i], title + ", " + names_[i], common_top(maps_())); });
    }

private:
    std::vector<std::string> names_;
    Lazy<std::vector<CostMap>> maps_;
};

// When is a cell a leaf?
void show_leaves(const ChapterRun& run, Page& page) {
    CostPictures(run, Cost::primitive_tests, {"grid", "octree"}).show(page, "tests", "tests a pixel");
    page.table("leaves", leaf_header(), [&] { return leaf_rows(run); });
}

// The ways to the next cell.
void show_ways(const ChapterRun& run, Page& page) {
    page.figure("up_and_down", draw_up_and_down);
    page.figure("blocks", draw_blocks);
    page.table("ways", way_header(), [&] { return way_rows(run); });
    CostPictures(run, Cost::steps, {"octree", "octree_hash"}).show(page, "steps", "steps a pixel");
}

void story(const ChapterRun& run, Page& page) {
    show_tree(run, page);
    show_leaves(run, page);
    show_ways(run, page);
    const Lazy<std::vector<StructureCost>> costs([&] {
        return growth_counts(run, structure_methods({"octree", "octree_hash", "octree_seads", "grid", "bvh"}));
    });
    page.figure("growth_tests", [&] { return growth_chart(costs(), GrowthOf::primitive_tests); });
    page.figure("growth_steps", [&] { return growth_chart(costs(), GrowthOf::steps); });
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"11_octree", "Octree", "Where does a ray go on?"},
                          .story = story,
                          .questions = {{"octree_next_cell", measure_octrees}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
