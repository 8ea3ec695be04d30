// Chapter 12: where is space to be cut? README.md is the lesson; here is what it shows.

#include "case_sketches.h"
#include "cases.h"
#include "drawings.h"
#include "painting.h"
#include "questions.h"

#include "raylab/accelerator/split_tree/kd_tree.h"
#include "raylab/base/lazy.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/report/structure/structure_diagram.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/structure/structure_growth.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/whitted_picture.h"

using namespace raylab;
using namespace raylab::split;

namespace {

constexpr int from_above = 1;       // along y
constexpr double waterline = 0.01;  // metres above the water: through all balls, nearly at their middles

// The trees of this page are split more finely than the lab's own, so that there is more to see.
const SahCosts dear_tests{.visit = 1, .test = 2, .empty_bonus = 0.2};
const std::vector<std::string> rules{"spatial", "object", "sah"};  // as in strong_trees()

using Trees = std::vector<std::unique_ptr<Accelerator>>;

Trees trees_of(const Scene& scene) {
    Trees trees;
    for (const StructureMethod& method : strong_trees(dear_tests)) trees.push_back(method.make(scene));
    return trees;
}

Image lake(const ChapterRun& run, const Scene& scene) {
    const int part = run.sized(1, 4);
    const CameraFrame frame =
        camera_frame(scene.camera, {scene.image.width / part, scene.image.height / part}, scene.source);
    return whitted_picture(scene, KdTree(scene), frame, {}, chapter_rays(run, 4));
}

// Three rules, three trees.
void show_rules(Page& page, const Scene& scene, const Lazy<Trees>& trees) {
    for (std::size_t i = 0; i < rules.size(); ++i)
        page.figure("cells_" + rules[i], [&, i] {
            PlaneDrawing cells = draw_structure(scene, trees()[i]->outline(),
                                                {.along = from_above, .slice = waterline, .width = 600, .height = 410});
            cells.notes.clear();  // the lesson's table counts
            return cells;
        });
    page.table("trees", {"tree", "nodes", "leaves", "empty", "things in leaves", "deepest"}, [&] {
        Page::Rows rows;
        for (std::size_t i = 0; i < rules.size(); ++i) {
            const auto size = dynamic_cast<const KdTree&>(*trees()[i]).size();
            rows.push_back({strong_trees()[i].name, std::to_string(size.nodes), std::to_string(size.leaves),
                            std::to_string(size.empty_leaves), std::to_string(size.references),
                            std::to_string(size.deepest)});
        }
        return rows;
    });
    page.figure("sweep", [&] { return sweep_chart(scene, dear_tests); });
}

// A ray goes from cell to cell.
void show_way(Page& page, const Scene& scene, const Lazy<Trees>& trees) {
    const Ray ray{{-6.5f, 0.05f, 3.4f}, {1, -0.001f, -0.7f}};
    page.figure("three_cases", draw_three_cases);
    const StructureView view{.along = from_above, .slice = waterline, .width = 620, .height = 430};
    page.figure("way", [&] { return draw_ray_through(scene, *trees().back(), ray, view); });
    page.figure("tree", [&] {
        const auto visits = trees().back()->visits(ray);
        return structure_diagram(trees().back()->outline(), "", {.largest = 17, .visits = visits});
    });
}

// The cost of a pixel, in the same colours for all three.
void show_costs(const ChapterRun& run, Page& page, const Scene& scene, const Lazy<Trees>& trees) {
    const Lazy<std::vector<CostMap>> maps([&] {
        const CameraFrame frame = camera_frame(scene.camera, {run.sized(640, 160), run.sized(360, 90)}, scene.source);
        std::vector<CostMap> all;
        for (const auto& tree : trees()) all.push_back(cost_map(*tree, frame, Cost::steps, run.threads));
        return all;
    });
    for (std::size_t i = 0; i < rules.size(); ++i)
        page.figure("steps_" + rules[i], [&, i] {
            return heat_map(maps()[i], "steps a pixel: " + strong_trees()[i].name, common_top(maps()));
        });
}

// Planes in any direction.
void show_painter(const ChapterRun& run, Page& page) {
    page.figure("plane_tree", draw_plane_tree);
    const Scene ring = beams(), rope = knot(run.sized(400, 120));
    const PaintersTree tree(ring), rope_tree(rope);
    page.figure("painted_by_distance", [&] { return shaded(ring, paint_by_distance(tree, frame_of(ring))); },
                {.keep = Page::Keep::floats});
    page.figure("painted", [&] { return shaded(ring, paint(tree, frame_of(ring))); }, {.keep = Page::Keep::floats});
    page.figure("pieces", [&] { return draw_pieces(ring, tree); });
    for (std::size_t quarters = 1; quarters <= 4; ++quarters)
        page.figure("quarters_" + std::to_string(quarters),
                    [&, quarters] { return after_quarters(rope, rope_tree, quarters); });
    page.table("painted", painter_header(), [&] { return painter_rows({ring, rope}); });
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    const Lazy<Trees> trees([&] { return trees_of(scene); });
    page.figure("lake", [&] { return lake(run, scene); });
    show_rules(page, scene, trees);
    show_way(page, scene, trees);
    show_painter(run, page);
    show_costs(run, page, scene, trees);
    const Lazy<std::vector<StructureCost>> costs([&] {
        auto methods = strong_trees();
        methods.push_back(structure_method("bvh"));
        return growth_counts(run, methods);
    });
    page.figure("growth_tests", [&] { return growth_chart(costs(), GrowthOf::primitive_tests); });
    page.figure("growth_steps", [&] { return growth_chart(costs(), GrowthOf::steps); });
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"12_bsp_and_kd_trees", "BSP and kd-trees", "Where is space to be cut?"},
                          .story = story,
                          .questions = {{"split_tree", measure_trees}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
