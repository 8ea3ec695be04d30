// Chapter 12: where is space to be divided?
//
// Planes perpendicular to an axis make a kd-tree, or axis-aligned BSP tree; planes in any direction make a general BSP
// tree, which gives a visibility order for every eye. README.md tells the same story, with the formulas.

#include "cases.h"
#include "painting.h"
#include "questions.h"

#include "raylab/accelerator/split_tree/kd_tree.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/structure/structure_diagram.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/structure/structure_growth.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/report/structure/structure_portraits.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/first_hit_picture.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::split;

namespace {

constexpr int from_above = 1;  // along y
constexpr double low = 0.11;   // metres above the table: through all balls

// The trees of this page are split more finely than the lab's own, so that there is more to see.
const SahCosts dear_tests{.visit = 1, .test = 2, .empty_bonus = 0.2};

std::string drawn(const PlaneDrawing& drawing, const ChapterRun& run, const std::string& name) {
    write_svg(drawing, run.out / (name + ".svg"));
    return write_picture(to_image(drawing), run.out, name);
}

// 1. Three rules, three trees: README (1) to (3).
void tell_rules(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Where to cut");
    page.text("Every cell is cut in two by a plane across one axis, until few things are in it. Which plane? The "
              "middle of the longest side knows nothing of what is in there. The median of the objects puts as many "
              "on either side, and so never finds out that half of a cell is empty. The surface area heuristic "
              "expects the least work of a ray that comes by chance.");
    page.figures({{write_picture(first_hit_picture(scene, KdTree(scene), frame_of(scene), FirstHitShading::light,
                                                   {.samples = {SamplePattern::jittered, run.sized(3, 1), run.seed},
                                                    .threads = run.threads}),
                                 run.out, "balls"),
                   "Some balls, a dozen beads in one place, and a table that lies in a plane itself."}});
    std::vector<Page::Figure> figures;
    const std::vector<std::string> names{"cells_spatial", "cells_object", "cells_sah"};
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const StructureMethod method = strong_trees(dear_tests)[i];
        const auto tree = method.make(scene);
        const StructureView view{.title = method.name, .along = from_above, .slice = low, .width = 560, .height = 380};
        figures.push_back({drawn(draw_structure(scene, tree->outline(), view), run, names[i]),
                           method.name + ": its cells a little above the table; empty ones are white."});
        const auto size = dynamic_cast<const KdTree&>(*tree).size();
        rows.push_back({method.name, std::to_string(size.nodes), std::to_string(size.leaves),
                        std::to_string(size.empty_leaves), std::to_string(size.references),
                        std::to_string(size.deepest)});
    }
    page.figures(figures);
    page.table({"tree", "nodes", "leaves", "empty", "things in leaves", "deepest"}, rows,
               "The same balls and table, in three trees; a test counts as two visits.");
}

// 2. A ray goes from cell to cell: README (4), (5).
void tell_way(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("The way of a ray");
    page.text("Down the tree the ray's part [begin, end] inside the cell is cut at the plane's t; the half on the "
              "ray's side comes first, the other waits on a stack. The first hit that lies before all that waits is "
              "the nearest: what is farther is never looked at.");
    const KdTree tree(scene, surface_area_heuristic(dear_tests));
    const Ray ray{{-6.5f, 0.115f, 3.4f}, {1, -0.001f, -0.62f}};
    const StructureView view{
        .title = "A ray, and the cells it visits in this order", .along = from_above, .slice = low};
    page.figures({{drawn(draw_ray_through(scene, tree, ray, view), run, "way"),
                   "Cells are numbered as they are visited, inner nodes too; bold: what is tested."}});
    const auto visits = tree.visits(ray);
    const auto diagram = structure_diagram(tree.outline(), "The kd-tree of the balls", {.visits = visits});
    write_diagram(diagram, run.out / "tree.png");
    page.figures({{"tree.png", "The same visits in the tree."}});
    page.text("The same ray through all three trees, their upper nodes, and what pixels cost in tests.");
    tell_portraits(run, page, strong_trees(dear_tests), scene, ray, view);
    page.figures({{write_picture(tests_of_each(run, strong_trees(dear_tests), scene), run.out, "tests_of_each"),
                   "Tests for each pixel."}});
}

// 3. The cost of a pixel.
void tell_costs(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("What a pixel costs");
    const CameraFrame frame = frame_of(scene);
    std::vector<CostMap> maps;
    for (const StructureMethod& method : strong_trees(dear_tests))
        maps.push_back(cost_map(*method.make(scene), frame, Cost::steps, run.threads));
    std::vector<Page::Figure> figures;
    const std::vector<std::string> names{"heat_spatial", "heat_object", "heat_sah"};
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::string title = "steps a pixel: " + strong_trees()[i].name;
        figures.push_back({write_picture(heat_map(maps[i], title, common_top(maps)), run.out, names[i]), title});
    }
    page.figures(figures);
}

// 4. Planes in any direction: README (6).
void tell_painter(const ChapterRun& run, Page& page) {
    page.heading("From every eye, back to front");
    page.text("Take the plane of one triangle, sort the others behind it and before it, and cut those that it goes "
              "through. Whoever looks from before it can paint what is behind, then the triangle, then what is "
              "before, without asking for any depth: Fuchs, Kedem and Naylor's tree is built once and serves every "
              "eye. Three beams that overlap in a ring have no order until one is cut.");
    const Scene ring = beams();
    const PaintersTree tree(ring);
    page.figures({{write_picture(shaded(ring, paint_by_distance(tree, frame_of(ring))), run.out, "painted_by_distance"),
                   "Expected failure: whole triangles, the farthest first."},
                  {write_picture(shaded(ring, paint(tree, frame_of(ring))), run.out, "painted"),
                   "By the tree: every pixel is the ray tracer's."}});
    page.figures({{drawn(draw_pieces(ring, tree), run, "pieces"), "The pieces, numbered as they are painted."}});
    const Scene rope = knot(run.sized(240, 120));
    page.figures(
        {{write_picture(steps(rope, PaintersTree(rope)), run.out, "painted_steps"), "A knot of 512 triangles."}});
    page.table(painter_header(), painter_rows({ring, rope}),
               "Judged pixel by pixel: the same triangle, and the same bits of t.");
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_rules(run, page, scene);
    tell_way(run, page, scene);
    tell_costs(run, page, scene);
    tell_painter(run, page);
    page.heading("As scenes grow");
    auto methods = strong_trees();
    methods.push_back(structure_method("bvh"));
    methods.push_back(structure_method("list"));
    tell_growth(run, page, methods);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"12_bsp_and_kd_trees", "BSP and kd-trees", "Where is space to be cut?"},
                          .story = story,
                          .questions = {{"split_tree", measure_trees}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
