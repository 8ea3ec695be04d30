#include "pictures.h"

#include "octree_kinds.h"

#include "raylab/experiment/structure/structure_question.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/report/structure/bound.h"
#include "raylab/report/structure/boxes_in_picture.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/scene/scene_bounds.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::octrees {

namespace {

constexpr int above = 1, before = 2;  // looking along y, along z
constexpr double low = 0.3, through_spheres = 0.7;

std::unique_ptr<Accelerator> octree_of(const Scene& scene, int cuts) {
    const OctreeLimits limits{.few = 1, .depth = cuts, .cut = OctreeLimits::Cut::always};
    return octree_by_points("octree", limits).make(scene);
}

}  // namespace

Image cells_in_picture(const Scene& scene, const ChapterRun& run) {
    const CameraFrame frame = camera_frame(scene.camera, {run.sized(1280, 320), run.sized(720, 180)}, scene.source);
    const auto octree = octree_of(scene, 5);
    const Image picture = whitted_picture(scene, *octree, frame, {}, chapter_rays(run, 4));
    constexpr float largest = 2;  // metres; larger leaves reach far beyond the picture
    std::vector<Box> full;
    for (const Outline::Node& node : octree->outline().nodes) {
        const Box cell = box_about(node.bound);
        if (!node.primitives.empty() && cell.max.x - cell.min.x < largest) full.push_back(cell);
    }
    return with_boxes(picture, frame, *octree, full);
}

PlaneDrawing draw_cuts(const Scene& scene, int cuts) {
    const Outline outline = octree_of(scene, cuts)->outline();
    const Box root = box_about(outline.nodes[0].bound);
    PlaneDrawing drawing =
        draw_structure(scene, outline, {.along = above, .slice = low, .shown = root, .width = 420, .height = 420});
    const auto leaves =
        std::ranges::count_if(outline.nodes, [](const Outline::Node& node) { return node.children.empty(); });
    drawing.title = fmt::format("{} cut{}, {} leaves", cuts, cuts == 1 ? "" : "s", leaves);
    drawing.notes.clear();
    return drawing;
}

Ray lesson_ray() { return {{-5.6f, 3.1f, 0.7f}, {1, -0.29f, 0}}; }

PlaneDrawing draw_way(const Scene& scene) {
    const auto octree = octree_of(scene, 5);
    PlaneDrawing drawing = draw_ray_through(scene, *octree, lesson_ray(),
                                            {.along = before, .slice = through_spheres, .width = 780, .height = 240});
    const Box contents = scene_bounds(scene);
    const PlanePoint a{contents.min.x, contents.min.y}, b{contents.max.x, contents.max.y};
    drawing.marks.push_back(PlaneDrawing::Figure{PlanePolygon{{a, {b.x, a.y}, b, {a.x, b.y}}},
                                                 {.line = "#009e73", .width = 3, .dash = PlaneStyle::Dash::dashed}});
    drawing.marks.push_back(PlaneDrawing::Text{{b.x, b.y},
                                               "the box of all primitives: the walk begins here",
                                               11,
                                               "#006b4e",
                                               Anchor::right,
                                               {0, -8},
                                               "#ffffff"});
    return drawing;
}

std::vector<std::string> cuts_header() {
    return {"cuts", "leaves", "of them empty", "names in leaves", "tests a ray", "steps a ray"};
}

std::vector<std::vector<std::string>> cuts_rows(const Scene& scene) {
    const auto rays = camera_rays("hall", std::make_shared<const Scene>(scene), 20'000);
    std::vector<std::vector<std::string>> rows;
    for (int cuts = 0; cuts <= 7; ++cuts) {
        const auto octree = octree_of(scene, cuts);
        std::size_t leaves = 0, empty = 0, names = 0;
        for (const Outline::Node& node : octree->outline().nodes) {
            if (!node.children.empty()) continue;
            ++leaves;
            empty += node.primitives.empty() ? 1 : 0;
            names += node.primitives.size();
        }
        Traversal traversal;
        answers_of(*octree, rays, traversal);
        const auto each = [&](std::uint64_t count) {
            return fmt::format("{:.2f}", static_cast<double>(count) / static_cast<double>(rays.rays.size()));
        };
        rows.push_back({std::to_string(cuts), std::to_string(leaves), std::to_string(empty), std::to_string(names),
                        each(traversal.primitive_tests), each(traversal.steps)});
    }
    return rows;
}

}  // namespace raylab::octrees
