// Chapter 11: where does a ray go on, if cells are of all sizes?
//
// A grid has the same cells everywhere. An octree divides space where there are primitives, and does not where there
// are none. The price is that the next cell's number is no longer the current one plus one. The formulas are in
// README.md, numbered as here, which tells the same story.

#include "cases.h"
#include "octree_methods.h"
#include "octree_workloads.h"

#include "raylab/image/draw.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/report/structure/structure_diagram.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/structure/structure_growth.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/report/structure/structure_portraits.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::octrees;

namespace {

// 1. Eight equal children: README (1).
void tell_tree(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Eight equal children");
    page.text("A cube around everything. It is cut through its middle three ways, into eight cubes of half the "
              "side, and each of these is again; where a cube is empty, or has few things in it, or is small, it "
              "stays whole: a leaf.");
    const auto octree = make_accelerator("octree:5", scene);
    const Ray ray{{-5.6f, 3.1f, 0.7f}, {1, -0.29f, 0}};
    const StructureView slice{.title = "cut at z = 0.7", .along = 2, .slice = 0.7, .width = 960, .height = 350};
    page.figures({{write_picture(to_image(draw_structure(scene, octree->outline(), slice)), run.out, "cells"),
                   "Cut through at z = 0.7. Cells are small where things are."},
                  {write_picture(to_image(draw_ray_through(scene, *octree, ray, slice)), run.out, "way"),
                   "A ray's way: large steps through nothing, small ones near things."}});
    const auto shallow = make_accelerator("octree:2", scene);
    const auto visits = shallow->visits(ray);
    write_diagram(structure_diagram(shallow->outline(), "an octree, two cuts deep", {.largest = 26, .visits = visits}),
                  run.out / "tree.png");
    page.figures({{"tree.png", "The same as a tree, two cuts deep; numbers and thick lines: where the ray goes."}});
    page.text("The lab's three octrees of the same scene: the same ray's way, the upper nodes, what pixels cost.");
    const auto kinds = structure_methods({"octree", "octree_hash", "octree_seads"});
    tell_portraits(run, page, kinds, scene, ray, slice);
    page.figures({{write_picture(tests_of_each(run, kinds, scene), run.out, "tests_of_each"),
                   "Tests for each pixel, in the same colours."}});
}

// 2. When is a cell a leaf? README (2).
void tell_leaves(const ChapterRun& run, Page& page) {
    page.heading("When is a cell a leaf?");
    page.text("When it is empty; when few things are in it; when it is small. And one reason more: when cutting "
              "does not pay. A ray through a cube hits one of its eighths with probability 1/4, so eighths that "
              "together hold four times as much as the cube did are no gain, and they cost memory.");
    page.table(leaf_header(), leaf_rows(run), "A knot in the corner of a hall; rays of a camera.");
    const auto scene = hall(run.sized(5, 4));
    const CameraFrame frame = camera_frame(scene->camera, {run.sized(300, 150), run.sized(300, 150)}, "hall");
    const std::vector<std::string> names{"grid", "octree"};
    std::vector<CostMap> maps;
    for (const std::string& name : names)
        maps.push_back(cost_map(*make_accelerator(name, *scene), frame, Cost::primitive_tests, run.threads));
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < names.size(); ++i)
        pictures.push_back(heat_map(maps[i], "tests a pixel, " + names[i], common_top(maps)));
    page.figures({{write_picture(side_by_side(pictures), run.out, "tests"),
                   "Tests for each pixel, in the same colours. The grid's cells are as wide near the knot as in the "
                   "empty hall."}});
}

// 3. Three ways to the next cell: README (3) to (6).
void tell_ways(const ChapterRun& run, Page& page) {
    page.heading("One octree, three ways to the next cell");
    page.text("By a *point* a short way on, and a search up and down the tree. By the point's cell's *name*, looked "
              "up in a hash table (Glassner). By *3D-DDA* from cell to cell of a block, as through a small grid, up "
              "and down between blocks (SEADS). All three go through the same leaves; they differ in how many cells "
              "they look at.");
    page.table(way_header(), way_rows(run),
               "Blocks larger than 2 x 2 x 2 cut their leaves at once: fewer looks, more cells.");
    const auto scene = hall(run.sized(5, 4));
    const CameraFrame frame = camera_frame(scene->camera, {run.sized(300, 150), run.sized(300, 150)}, "hall");
    std::vector<CostMap> maps;
    for (const auto& method : exact_ways())
        maps.push_back(cost_map(*method.make(*scene), frame, Cost::steps, run.threads));
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < maps.size(); ++i)
        pictures.push_back(heat_map(maps[i], "cells looked at, " + exact_ways()[i].name, common_top(maps)));
    page.figures({{write_picture(side_by_side(pictures), run.out, "looks"),
                   "Cells looked at for each pixel, in the same colours."}});
}

void story(const ChapterRun& run, Page& page) {
    tell_tree(run, page, read_scene(run.scene));
    tell_leaves(run, page);
    tell_ways(run, page);
    page.heading("As scenes grow");
    tell_growth(run, page, structure_methods({"octree", "octree_hash", "octree_seads", "grid", "bvh"}));
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"11_octree", "Octree", "Where does a ray go on?"},
                          .story = story,
                          .questions = {{"octree_next_cell", measure_octrees}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
