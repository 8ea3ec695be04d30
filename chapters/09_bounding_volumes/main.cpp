// Chapter 09: can most tests be skipped?
//
// A ray that misses an object's bounding volume misses the object, and one that misses the bounding volume of many
// misses them all. So a few cheap tests replace many expensive ones, provided that no bounding volume is missed that is
// hit. README.md is the lesson; this program makes what it shows.

#include "box_tests.h"
#include "case_sketches.h"
#include "cases.h"
#include "cuts_of_six.h"
#include "drawings.h"
#include "splits.h"
#include "trees.h"
#include "void_area.h"

#include "raylab/base/lazy.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/report/chapter.h"
#include "raylab/report/structure/structure_diagram.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/structure/structure_growth.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::volumes;

namespace {

// Bounding volumes, and the empty space in them.
void show_void(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("void_spheres", [&] { return void_picture(scene(), Volume::sphere, run); });
    page.figure("void_boxes", [&] { return void_picture(scene(), Volume::box, run); }, {.keep = Page::Keep::floats});
    page.figure("void_oriented_boxes", [&] { return void_picture(scene(), Volume::oriented_box, run); });
    page.figure("cauchy", [] { return draw_cauchy(); });
    page.figure("shadows_of_cube", [] { return draw_shadows_of_cube(); });
    page.table("void", void_header(), [&] { return void_rows(scene(), run); });
    page.figure("slabs", [] { return draw_slabs(); });
}

// Trees of bounding volumes: a ray's way, the nodes it visits.
void show_trees(const ChapterRun& run, Page& page) {
    const Scene few = mesh_scene(std::make_shared<Mesh>(trefoil_knot(0.35, 4)), "knot");
    const Ray ray{{-4, 0.4f, 1.9f}, {1, 0.12f, -0.34f}};
    const Scene twenty = mesh_scene(std::make_shared<Mesh>(icosphere(0)), "icosahedron");
    page.figure("tree", [&] {
        const auto tree = make_accelerator("bvh", twenty);
        const auto visits = tree->visits({{-3, 0.1f, 0.2f}, {1, 0, 0}});
        return structure_diagram(tree->outline(), "twenty triangles", {.visits = visits});
    });
    const Lazy<std::shared_ptr<const Scene>> tube([&] { return knot(run.sized(6, 4)); });
    const Lazy<std::vector<CostMap>> maps([&] {
        const int side = run.sized(640, 200);
        const CameraFrame frame = camera_frame(tube()->camera, {side, side}, "knot");
        std::vector<CostMap> found;
        for (const StructureMethod& method : trees())
            found.push_back(cost_map(*method.make(*tube()), frame, Cost::steps, run.threads));
        return found;
    });
    for (std::size_t i = 0; i < trees().size(); ++i) {
        const StructureMethod method = trees()[i];
        page.figure("way_" + method.name, [&] {
            // Without numbers: the boxes overlap, and theirs would hide what the ray meets.
            PlaneDrawing way =
                draw_ray_through(few, *method.make(few), ray, {.width = 420, .height = 350, .max_numbers = 0});
            way.notes.clear();
            return way;
        });
        page.figure("visited_" + method.name,
                    [&] { return heat_map(maps()[i], "nodes visited, " + method.name, common_top(maps())); });
    }
    page.table("kinds", counts_header(), [&] { return counts_rows(trees(), run); });
}

// Where to cut, how deep, and what grows.
void show_cuts(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("cuts", [&] { return draw_cuts(scene()); });
    page.table("cuts", cuts_header(), [&] { return cuts_rows(scene()); });
    page.table("rules", counts_header(), [&] { return counts_rows(cuts(), run); });
    page.table("depths", depth_header(), [&] { return depth_rows(run); });
    const Lazy<std::vector<StructureCost>> growth([&] { return growth_counts(run, trees()); });
    page.figure("growth_steps", [&] { return growth_chart(growth(), GrowthOf::steps); });
    page.figure("growth_tests", [&] { return growth_chart(growth(), GrowthOf::primitive_tests); });
    const Lazy<std::vector<SplitScene>> scenes([&] { return split_scenes(run); });
    page.figure("splits", [&] { return splits_chart(scenes()); });
    page.table("splits", splits_header(), [&] {
        auto rows = splits_rows(scenes());
        if (run.effort == ChapterRun::Effort::full)
            for (auto& row : splits_rows(real_split_scenes(run))) rows.push_back(std::move(row));
        return rows;
    });
}

// The slab test, and how it goes wrong.
void show_test(const ChapterRun& run, Page& page) {
    const auto city = [&](const StructureMethod& method) { return city_through(method, run.sized(160, 64)); };
    page.figure("city_fmin", [&] { return city(weak_trees()[0]); });
    page.figure("city_min", [&] { return city(weak_trees()[1]); });
    page.figure("city", [&] { return city(trees()[1]); });
    page.table("missed", missed_header(), [&] { return missed_rows(run); });
}

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    show_void(run, page, scene);
    show_trees(run, page);
    show_cuts(run, page, scene);
    show_test(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"09_bounding_volumes", "Bounding volumes", "Can most tests be skipped?"},
                          .story = story,
                          .questions = {{"ray_box", measure_ray_box}, {"hierarchy", measure_hierarchies}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
