// Chapter 15: what is blur?
//
// A mean: over the pixel, the lens, the lobe, the light, the time that the shutter is open. One ray through each sample
// of all of them estimates all means at once (Cook, Porter and Carpenter 1984); a path that goes on from diffuse
// surfaces too estimates all of the light (Kajiya 1986). README.md is the lesson; this program makes what it shows.

#include "case_sketches.h"
#include "cases.h"
#include "drawings.h"
#include "sampling_question.h"
#include "spread_picture.h"
#include "tables.h"

#include "raylab/base/lazy.h"
#include "raylab/image/draw.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/report/ray_tree/ray_tree_diagram.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::spread;

namespace {

const std::string folder = "chapters/15_distributed/";

ImageSize half(const ChapterRun& run) { return run.sized(ImageSize{480, 300}, ImageSize{160, 100}); }

std::string command(const std::string& name, const std::string& options) {
    return fmt::format("./raylab render {}scenes/{}.toml {} -o {}.png", folder, name, options, name);
}

// One scene twice: each ray goes one way, or all of its numbers are used.
void pair(const ChapterRun& run, Page& page, const std::string& without, const std::string& scene,
          const std::string& with) {
    page.figure(without, [&run, scene] { return chapter_picture(scene_named(scene), half(run), run); },
                {.command = command(scene, "--model whitted --samples 3x3")});
    page.figure(with, [&run, scene] { return spread_picture(scene_named(scene), half(run), {}, run); },
                {.command = command(scene, "--samples 32")});
}

// 1. The five pairs: README (1).
void draw_pairs(const ChapterRun& run, Page& page) {
    page.figure("hard_shadow", [&] { return chapter_picture(scene_named("hard_shadow"), half(run), run); },
                {.command = command("hard_shadow", "--samples 3x3")});
    page.figure("soft_shadow", [&] { return spread_picture(scene_named("soft_shadow"), half(run), {}, run); },
                {.command = command("soft_shadow", "--samples 32")});
    pair(run, page, "sharp_mirror", "gloss", "blurry_mirror");
    pair(run, page, "pinhole", "lens", "lens");
    pair(run, page, "frozen", "motion", "motion");
    const ImageSize coarse = run.sized(ImageSize{96, 60}, ImageSize{48, 30});
    page.figure("aliased", [&, coarse] {
        return enlarged(spread_picture(scene_named("filter"), coarse, {.sampler = {SamplerKind::random, 1}}, run), 5);
    });
    page.figure("filtered", [&, coarse] {
        const Samples samples{.sampler = {SamplerKind::sobol, 64}, .filter = PixelFilter::mitchell};
        return enlarged(spread_picture(scene_named("filter"), coarse, samples, run), 5);
    });
}

// 2. Numbers and what they become.
void draw_samples(const ChapterRun& run, Page& page) {
    page.figure("patterns", [&] { return draw_patterns(run.seed); });
    page.figure("thin_lens", draw_thin_lens);
    page.table("slopes", slope_header(), [&] { return slope_rows(run); });
    const auto soft = [&](SamplerKind kind, int count) {
        return spread_picture(scene_named("soft_shadow"), half(run), {.sampler = {kind, count}}, run);
    };
    page.figure("one_random", [soft] { return soft(SamplerKind::random, 1); });
    page.figure("one_blue_noise", [soft] { return soft(SamplerKind::blue_noise, 1); });
    page.figure("sixteen_random", [soft] { return soft(SamplerKind::random, 16); });
    page.figure("sixteen_sobol", [soft] { return soft(SamplerKind::sobol, 16); });
    page.figure("adaptive", [&] { return sample_counts(scene_named("soft_shadow"), half(run), run); });
}

// 3. Two strategies for one integral: README (6).
void draw_strategies(const ChapterRun& run, Page& page) {
    const auto plates = [&](LightStrategy strategy) {
        return spread_picture(scene_named("plates"), half(run),
                              {.sampler = {SamplerKind::random, 16}, .options = {.strategy = strategy}}, run);
    };
    page.figure("by_lights", [plates] { return plates(LightStrategy::lights); });
    page.figure("by_lobes", [plates] { return plates(LightStrategy::lobes); });
    page.figure("by_both", [plates] { return plates(LightStrategy::both); });
}

// 4. All of the light: README (7).
void draw_paths(const ChapterRun& run, Page& page) {
    const auto colonnade = [&](TransportOptions options, int samples) {
        return spread_picture(scene_named("colonnade"), half(run),
                              {.sampler = {SamplerKind::sobol, samples}, .options = options}, run);
    };
    page.figure("colonnade", [colonnade] { return colonnade(paths(), 256); },
                {.command = command("colonnade", "--size 480x300 --samples 256"), .keep = Page::Keep::floats});
    page.figure("colonnade_direct", [colonnade] {
        TransportOptions once = paths();
        once.depth = 1;
        return colonnade(once, 32);
    });
    page.table("box", box_header(), [&] { return box_rows(run); });
}

// A sample that meets the bronze ball first, and then walls.
constexpr auto path_command =
    "./raylab tree chapters/15_distributed/scenes/colonnade.toml --pixel 355,302 --sample 7 --shadow-rays -o path.svg";

Diagram draw_path(const ChapterRun& run) {
    const Scene scene = scene_named("colonnade");
    const CameraFrame frame = camera_frame(scene.camera, scene.image);
    const auto accelerator = make_accelerator("auto", scene);
    const TransportPicture picture(scene, *accelerator, frame, paths());
    return ray_tree_diagram(picture.tree({.seed = run.seed}, 355, 302, 7), "One sample of a pixel is one path",
                            {.shadow_rays = RayTreeView::ShadowRays::shown});
}

void story(const ChapterRun& run, Page& page) {
    const Lazy<Scene> scene([&] { return read_scene(run.scene); });
    const ImageSize size = run.sized(scene().image, ImageSize{160, 100});
    page.figure("billiards",
                [&] {
                    return spread_picture(scene(), size, {.sampler = {SamplerKind::sobol, 64}}, run);
                },
                {.command = "./raylab render chapters/15_distributed/scene.toml --samples 64 -o billiards.png",
                 .keep = Page::Keep::floats});
    page.figure("billiards_frozen", [&] { return chapter_picture(scene(), size, run); });
    draw_pairs(run, page);
    draw_samples(run, page);
    page.figure("tree", [&] { return draw_path(run); }, {.command = path_command});
    draw_strategies(run, page);
    draw_paths(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"15_distributed", "Distributed rays and paths", "What is blur?"},
                          .story = story,
                          .questions = {{"sampling", measure_sampling}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
