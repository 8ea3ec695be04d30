// Chapter 09: can most tests be skipped?
//
// A ray that misses an object's bounding volume misses the object, and one that misses the bounding volume of many
// misses them all. So a few cheap tests replace many expensive ones, provided that no bounding volume is missed that is
// hit. The formulas are in README.md, numbered as here, which tells the same story.

#include "box_tests.h"
#include "cases.h"
#include "splits.h"
#include "trees.h"
#include "void_area.h"

#include "raylab/experiment/generate/generate.h"
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
using namespace raylab::volumes;

namespace {

// 1. The scene, and the empty space in its bounding volumes: README (1) to (3).
void tell_void(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("A bound, and the void in it");
    page.text("A ray that misses a sphere around a thing misses the thing. One that hits the sphere has to be "
              "tested against the thing after all, and often in vain: how often, the *void area* says, what of the "
              "bound's shadow is not the thing's.");
    page.figures({{write_picture(void_picture(scene, run), run.out, "void"),
                   "The redder, the more bounds a ray hits in vain. A slanted rod nearly fills an oriented box, "
                   "and its box hardly."}});
    page.table(void_header(), void_rows(scene, run), "How much of each bound's shadow is void, seen from everywhere.");
}

const std::vector<std::string> kinds{"bvh_sphere", "bvh", "bvh_obb"};

// 2. Bounding volume hierarchies: README (4).
void tell_hierarchies(const ChapterRun& run, Page& page) {
    page.heading("Bounds of bounds");
    page.text("Around two bounds goes a third, and so on up to a root: a tree. A ray that misses the bound of a "
              "branch misses all that hangs there. Of two children the nearer one is entered first, and what begins "
              "beyond the hit found so far is left alone.");
    const Scene few = mesh_scene(std::make_shared<Mesh>(trefoil_knot(0.35, 4)), "knot");
    const Ray ray{{-4, 0.4f, 1.9f}, {1, 0.12f, -0.34f}};
    StructureView view{.width = 580, .height = 420, .max_numbers = 30};
    for (const std::string kind : {"bvh", "bvh_obb"}) {  // for README.md
        view.title = kind;
        write_picture(to_image(draw_ray_through(few, *make_accelerator(kind, few), ray, view)), run.out, "way_" + kind);
    }
    const Scene twenty = mesh_scene(std::make_shared<Mesh>(icosphere(0)), "icosahedron");
    const auto tree = make_accelerator("bvh", twenty);
    const auto visits = tree->visits({{-3, 0.1f, 0.2f}, {1, 0, 0}});
    write_diagram(structure_diagram(tree->outline(), "twenty triangles", {.visits = visits}), run.out / "tree.png");
    page.figures({{"tree.png", "The boxes around an icosahedron, as a tree; numbers and thick lines: where one ray "
                               "goes."}});
    page.text("All four trees of a knot: a ray's way, the upper nodes, what pixels cost.");
    tell_portraits(run, page, trees(), few, ray, view);
    page.figures({{write_picture(tests_of_each(run, trees(), few), run.out, "tests_of_each"),
                   "Tests for each pixel, in the same colours."}});
}

// 3. Their cost, and where to split: README (5).
void tell_costs(const ChapterRun& run, Page& page) {
    page.heading("Closer or cheaper?");
    page.text("An oriented box holds a thing more closely than a sphere does, and takes longer to test. The work "
              "for a ray is n_b B + n_o O: so many bounds at the price of one, so many things at the price of one.");
    const auto scene = knot(run.sized(6, 4));
    const CameraFrame frame = camera_frame(scene->camera, {run.sized(320, 200), run.sized(320, 200)}, "knot");
    std::vector<CostMap> maps;
    for (const std::string& kind : kinds)
        maps.push_back(cost_map(*make_accelerator(kind, *scene), frame, Cost::steps, run.threads));
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < maps.size(); ++i)
        pictures.push_back(heat_map(maps[i], "nodes visited, " + kinds[i], common_top(maps)));
    page.figures({{write_picture(side_by_side(pictures), run.out, "visited"),
                   "Nodes visited for each pixel, in the same colours."}});
    page.table(counts_header(), counts_rows(trees(), run), "A ray's work on the knot.");
    page.heading("Where to cut");
    page.text("A tree is made from the top: all things are cut in two, both parts again. At the median of their "
              "centers both parts are equal; but a ray does not care for numbers of things, it hits large boxes "
              "oftener than small ones. The surface area heuristic weighs both.");
    page.table(counts_header(), counts_rows(cuts(), run), "The same rays, trees of boxes cut by three rules.");
    page.table(depth_header(), depth_rows(run), "How deep? Cut at the median until so many triangles are left.");
    tell_splits(run, page);
    page.heading("As scenes grow");
    tell_growth(run, page, trees());
}

// 4. The test itself: README (6) to (8).
void tell_test(const ChapterRun& run, Page& page) {
    page.heading("Three lines, three traps");
    page.text("The box test looks like three lines of code. It is asked more often than anything else in a ray "
              "tracer, and one box that is missed by mistake high up in a tree loses all that is in it.");
    const auto weak = weak_trees();
    page.figures({{write_picture(city_through(weak[0], run.sized(160, 64)), run.out, "city_fmin"),
                   "Expected failure: towers from above, boxes tested with fmin and fmax. Red: wrong."},
                  {write_picture(city_through(weak[1], run.sized(160, 64)), run.out, "city_min"),
                   "Expected failure: with std::min and std::max."},
                  {write_picture(city_through(trees()[1], run.sized(160, 64)), run.out, "city"),
                   "The lab's tree: where 0 * infinity says nothing, "
                   "the slab decides nothing."}});
    page.table(missed_header(), missed_rows(run),
               "Boxes in a million that are hit and said to be missed, by rays "
               "of six kinds.");
}

void story(const ChapterRun& run, Page& page) {
    tell_void(run, page, read_scene(run.scene));
    tell_hierarchies(run, page);
    tell_costs(run, page);
    tell_test(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"09_bounding_volumes", "Bounding volumes", "Can most tests be skipped?"},
                          .story = story,
                          .questions = {{"ray_box", measure_ray_box}, {"hierarchy", measure_hierarchies}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
