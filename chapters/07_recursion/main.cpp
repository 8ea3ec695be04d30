// Chapter 07: what does one see in a mirror or a glass?
//
// Where the eye ray hits a surface, a reflected and a refracted ray begin, and each returns what an eye would see
// there. The formulas are in README.md, numbered as here.

#include "cases.h"
#include "pictures.h"
#include "refraction.h"
#include "tables.h"
#include "termination.h"

#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/report/provenance.h"
#include "raylab/report/ray_tree/ray_tree_diagram.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::recursion;

namespace {

// Widths and heights of pictures, and samples along a pixel's side.
ImageSize large(const ChapterRun& run) { return run.sized(ImageSize{480, 360}, ImageSize{400, 300}); }
ImageSize small(const ChapterRun& run) { return run.sized(ImageSize{320, 240}, ImageSize{200, 150}); }
int per_side(const ChapterRun& run) { return run.sized(2, 1); }

constexpr auto by_fresnel = WhittedOptions::Reflectance::fresnel;

// 1. The sum: README (1).
void tell_sum(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("A pixel is a sum over a tree");
    page.text("Where a ray hits, three things are seen: the lit surface, what it mirrors, and what shows "
              "through it. *I = I_local + k_r I_reflected + k_t I_transmitted*; the last two are pixels of their own.");
    page.figures({{write_picture(seen(scene, {.depth = 7}, large(run), per_side(run), run), run.out, "still_life"),
                   "The scene, depth 7."}});
    const Terms parts = terms(scene, {.depth = 7}, small(run), run);
    page.figures(
        {{write_picture(parts.local, run.out, "local"), "I_local of the first hit,"},
         {write_picture(parts.reflected, run.out, "reflected"), "k_r I_reflected,"},
         {write_picture(parts.transmitted, run.out, "transmitted"), "and k_t I_transmitted: the sum is the picture."}});
}

// 2. All rays of one pixel: README (2).
void tell_tree(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("The ray tree");
    page.text("One eye ray through the large glass ball, and all rays that it spawned, to depth 4. The throughput "
              "of a ray is the product of the shares on the way to it; what a node adds to the pixel is its "
              "throughput times the light made there.");
    const auto accelerator = make_accelerator("auto", scene);
    const CameraFrame frame = camera_frame(scene.camera, {640, 480}, scene.source);
    const RayTree tree = ray_tree(scene, *accelerator, {.depth = 4}, eye_ray(frame, 430.5, 330.5));
    for (const auto* name : {"ray_tree.svg", "ray_tree.png"})
        write_diagram(ray_tree_diagram(tree, "Pixel (430, 330), depth 4"), run.out / name);
    page.figures({{"ray_tree.svg", "L, R and T: what is made here, what is reflected, what is transmitted."}});
}

// 3. Layer by layer.
void tell_depth(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Depth by depth");
    page.text("Depth 1 is the eye ray alone: mirrors are black and glass is nothing but a highlight. Depth 2 shows "
              "the mirror ball's world; a glass ball needs 3 rays, in, through and out; what is seen in a mirror "
              "through glass needs more.");
    std::vector<Page::Figure> figures;
    for (int depth = 1; depth <= 7; ++depth)
        figures.push_back({write_picture(seen(scene, {.depth = depth}, small(run), per_side(run), run), run.out,
                                         fmt::format("depth_{}", depth)),
                           fmt::format("Depth {}.", depth)});
    page.figures(figures);
}

// 4. The direction of the refracted ray, and its share of the light: README (3) to (7).
void tell_refraction(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Snell says where, Fresnel how much");
    page.text("At the surface the ray bends: *n sin(angle)* stays. From the denser side there are angles with no "
              "way out: total internal reflection. Whitted's k_r and k_t are constants of the material; a real surface "
              "shares its light by the angle.");
    page.figures({{write_picture(draw_snell(), run.out, "snell"), "From water into air; a stroke's width is its "
                                                                  "share of the light."}});
    const Scene pool = read_scene(source_folder() / "chapters/07_recursion/pool.toml");
    const WhittedOptions clear_water{.depth = 5, .reflectance = by_fresnel, .shadows = WhittedOptions::Shadows::none};
    page.figures({{write_picture(seen(pool, clear_water, large(run), per_side(run), run), run.out, "under_water"),
                   "Up from under water: all the room in a round window, around it the pool's bottom, totally "
                   "reflected. (Without shadow rays: to them the water's surface is opaque.)"}});
    const auto constant = seen(scene, {.depth = 7}, small(run), per_side(run), run);
    const auto fresnel = seen(scene, {.depth = 7, .reflectance = by_fresnel}, small(run), per_side(run), run);
    page.figures({{write_picture(constant, run.out, "constant"), "Constant k_r and k_t."},
                  {write_picture(fresnel, run.out, "fresnel"), "Fresnel: clear in the middle, a mirror at the rim."}});
    if (!write_chart(fresnel_chart(), run.out, "fresnel_curves").empty() &&
        std::filesystem::exists(run.out / "fresnel_curves.svg"))
        page.figures({{"fresnel_curves.svg", "From glass, the popular approximation is wrong from 30 degrees on."}});
}

// 5. When to stop: README (8).
void tell_termination(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("When to stop");
    page.text("A branch ends at a surface that neither mirrors nor transmits, or at no surface at all. What goes on "
              "must be cut: at a depth, or where the product of the shares on the way, its *throughput*, says that "
              "nobody would see it.");
    page.figures({{write_picture(rays_picture(scene, {.depth = 10}, small(run), run), run.out, "rays_depth"),
                   "Rays a pixel at depth 10."},
                  {write_picture(rays_picture(scene, {.depth = 10, .threshold = 0.01}, small(run), run), run.out,
                                 "rays_threshold"),
                   "The same, throughputs above 0.01 only."}});
    page.table(endings_header(), endings_rows(scene, run.threads), "Why branches end.");
}

// 6. Rooms whose exact colours are known: README (9), (10).
void tell_truth(Page& page) {
    page.heading("A hall of mirrors has a closed form");
    page.text("Two facing mirrors that glow with L and reflect rho show L + rho L + rho^2 L + ... = L / (1 - rho). "
              "The recursion must converge to it, and a cut must cost what the bound says.");
    page.table({"depth", "rho = 0.5", "rho = 0.9"}, hall_of_mirrors_rows(), "The brightness seen, L = 1.");
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_sum(run, page, scene);
    tell_tree(run, page, scene);
    tell_depth(run, page, scene);
    tell_refraction(run, page, scene);
    tell_termination(run, page, scene);
    tell_truth(page);
}

std::vector<StabilityCase> cases(const ChapterRun& run) {
    auto all = refraction_cases(run);
    for (auto& each : room_cases()) all.push_back(std::move(each));
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"07_recursion", "Recursion", "What does a mirror, a glass show?"},
                          .story = story,
                          .questions = {{"refraction", measure_refraction}, {"termination", measure_termination}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
