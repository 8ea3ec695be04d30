// Chapter 07: what does one see in a mirror or a glass?
//
// Where the eye ray hits a surface, a reflected and a refracted ray begin, and each returns what an eye would see
// there. The lesson is README.md; this program makes its figures and tables.

#include "case_sketches.h"
#include "cases.h"
#include "pictures.h"
#include "refraction.h"
#include "section.h"
#include "surface_drawings.h"
#include "tables.h"
#include "termination.h"

#include "raylab/base/lazy.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/report/provenance.h"
#include "raylab/report/ray_tree/pixel_trees.h"
#include "raylab/report/ray_tree/ray_tree_diagram.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::recursion;

namespace {

constexpr auto by_fresnel = WhittedOptions::Reflectance::fresnel;
constexpr auto scene_file = "chapters/07_recursion/scene.toml";

// Widths and heights of pictures.
ImageSize large(const ChapterRun& run) { return run.sized(ImageSize{1280, 960}, ImageSize{320, 240}); }
ImageSize third(const ChapterRun& run) { return run.sized(ImageSize{480, 360}, ImageSize{160, 120}); }
ImageSize half(const ChapterRun& run) { return run.sized(ImageSize{640, 480}, ImageSize{160, 120}); }

// Which rays of a tree are drawn.
template <class Wanted>
std::vector<std::size_t> nodes_where(const RayTree& tree, const Wanted& wanted) {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (wanted(i)) nodes.push_back(i);
    return nodes;
}

// 1. One ray after the other in a section through a small scene: README (1).
void draw_rays(Page& page) {
    page.figure("hit", draw_hit);
    const Scene section = read_scene(source_folder() / "chapters/07_recursion/section.toml");
    const RayTree tree = section_tree(section);
    const auto step = [&](const std::string& name, const RayTree& rays, const auto& wanted) {
        page.figure(name, [&] { return section_with_rays(section, rays, nodes_where(rays, wanted)); });
    };
    const RayTree above = section_tree_towards(section, {0, 2.6, 0}),
                  floor = section_tree_towards(section, {-2.2, 0, 0});
    const auto eye = [](std::size_t i) { return i == 0; };
    const auto any = [](std::size_t) { return true; };
    step("step_miss", above, any);
    step("step_hit", floor, eye);
    step("step_shadow", floor, any);
    step("step_reflected", tree, [&](std::size_t i) { return i < 3; });
    step("step_transmitted", tree, [&](std::size_t i) { return i == 0 || tree.nodes[i].kind == RayKind::transmitted; });
    step("step_all", tree, any);
    page.figure("rays_and_tree", [&] { return rays_beside_tree(section, tree); });
    page.table("ray_sum", ray_sum_header(), [&] { return ray_sum_rows(section, tree); });
}

// 2. The chapter's scene: its picture as a sum, and depth by depth: README (2).
void draw_scene(const ChapterRun& run, Page& page, const Lazy<Scene>& scene, const Lazy<Terms>& sum) {
    page.figure("still_life",
                [&] { return chapter_picture(scene(), large(run), run, {.depth = 7, .reflectance = by_fresnel}); },
                {.command = fmt::format("./raylab render {} --fresnel --depth 7 --threshold 0 --size 1280x960 "
                                        "--samples 3x3 -o still_life.png",
                                        scene_file)});
    page.pixel_trees("still_life", [&] {
        return pixel_trees_script(
            {.scene = scene(),
             .accelerator = *make_accelerator("auto", scene()),
             .image = {1280, 960},
             .options = {.depth = 7, .reflectance = by_fresnel},
             .command = fmt::format("./raylab tree {} --fresnel --depth 7 --threshold 0 --size 1280x960", scene_file)});
    });
    page.figure("local", [&] { return sum().local; });
    page.figure("reflected", [&] { return sum().reflected; });
    page.figure("transmitted", [&] { return sum().transmitted; });
    page.figure("sum", [&] { return sum().sum; });
    for (int depth = 1; depth <= 7; ++depth)
        page.figure(fmt::format("depth_{}", depth),
                    [&, depth] { return chapter_picture(scene(), third(run), run, {.depth = depth}); });
    page.figure("ray_tree", [&] {
        const auto accelerator = make_accelerator("auto", scene());
        const CameraFrame frame = camera_frame(scene().camera, {640, 480}, scene().source);
        return ray_tree_diagram(ray_tree(scene(), *accelerator, {.depth = 3}, eye_ray(frame, 430.5, 330.5)),
                                "Pixel (430, 330), depth 3");
    });
}

// 3. The direction of the refracted ray, and its share of the light: README (3) to (7).
void draw_refraction(const ChapterRun& run, Page& page, const Lazy<Scene>& scene, const Lazy<Terms>& sum) {
    page.figure("snell_vectors", draw_snell_vectors);
    page.table("worked_refraction", {"step", "x", "y"}, worked_refraction_rows);
    page.figure("snell", draw_snell);
    page.figure("under_water", [&] {
        const Scene pool = read_scene(source_folder() / "chapters/07_recursion/pool.toml");
        return chapter_picture(pool, half(run), run,
                               {.depth = 5, .reflectance = by_fresnel, .shadows = WhittedOptions::Shadows::none});
    });
    page.figure("constant", [&] { return sum().sum; }, {.command = {}, .keep = Page::Keep::floats});
    page.figure("fresnel",
                [&] { return chapter_picture(scene(), half(run), run, {.depth = 7, .reflectance = by_fresnel}); },
                {.command = {}, .keep = Page::Keep::floats});
    page.figure("fresnel_curves", fresnel_chart);
    page.figure("into_facet", draw_mirrored_into_facet);
}

// 4. When to stop: README (8) to (10).
void draw_termination(const ChapterRun& run, Page& page, const Lazy<Scene>& scene) {
    page.figure("rays_depth", [&] { return rays_picture(scene(), {.depth = 10}, half(run), run); });
    page.figure("rays_threshold",
                [&] { return rays_picture(scene(), {.depth = 10, .threshold = 0.01}, half(run), run); });
    page.table("endings", endings_header(), [&] { return endings_rows(scene(), run.threads); });
    page.table("hall_of_mirrors", {"depth", "ρ = 0.5", "ρ = 0.9"}, hall_of_mirrors_rows);
}

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    const Lazy<Terms> sum([&] { return terms(scene(), {.depth = 7}, half(run), run); });
    draw_rays(page);
    draw_scene(run, page, scene, sum);
    draw_refraction(run, page, scene, sum);
    draw_termination(run, page, scene);
}

std::vector<StabilityCase> cases(const ChapterRun& run) {
    auto all = refraction_cases(run);
    for (auto& each : room_cases(run)) all.push_back(std::move(each));
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"07_recursion", "Recursion", "What does a mirror, a glass show?"},
                          .story = story,
                          .questions = {{"refraction", measure_refraction}, {"termination", measure_termination}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
