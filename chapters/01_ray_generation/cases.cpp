#include "cases.h"

#include "case_rows.h"
#include "light_paths.h"
#include "pixel_samples.h"

#include "raylab/image/color.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/read_scene.h"

namespace raylab::ray_generation {

namespace {

// ---- HALF-PIXEL

// The error, in pixels, of a disk's centroid that is computed from the pixels whose one ray hits it.
double centroid_off(double sample) {
    constexpr int side = 200;
    const double center_x = 100, center_y = 100, radius = 60;
    double sum_x = 0, sum_y = 0, count = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (std::hypot(x + sample - center_x, y + sample - center_y) > radius) continue;
            sum_x += x + 0.5, sum_y += y + 0.5, ++count;
        }
    return std::max(std::abs(sum_x / count - center_x), std::abs(sum_y / count - center_y));
}

std::vector<CaseRow> half_pixel() {
    return {holds("rays through pixel centres", " px", centroid_off(0.5), 1e-9),
            fails("rays through pixel corners", " px", centroid_off(0), 0.49)};
}

// ---- PINHOLE

std::vector<CaseRow> pinhole(const ChapterRun& run) {
    const Scene scene = read_scene(run.scene);
    const auto list = make_accelerator("list", scene);
    const CameraFrame frame = camera_frame(scene.camera, {160, 120}, scene.source);
    std::vector<CaseRow> rows;
    for (const double radius : {0.0, 0.5}) {
        const std::uint64_t rays = run.sized(400000, 60000);
        const auto result = trace_forward(
            scene, *list, frame, {.eye_radius = radius, .light_rays = rays, .seed = run.seed, .threads = run.threads});
        const Share share = result.share(Fate::in_picture);
        const bool expected = radius == 0 ? share.happened == 0 : share.happened > 0;
        rows.push_back({fmt::format("forward, eye of radius {} m", radius),
                        radius == 0 ? "fails: no ray arrives" : "holds: some rays arrive",
                        fmt::format("{} of {} light rays (95 %: at most {:.2g})", share.happened, rays, share.high),
                        expected});
    }
    return rows;
}

// ---- BOTH-WAYS

// The mean luminance of a picture, and its standard error: most pixels of a forward picture have at most one arrival.
struct Brightness {
    double mean, deviation;
};

Brightness brightness(const Image& picture) {
    double sum = 0, squares = 0;
    for (const Pixel& pixel : picture.pixels()) {
        sum += luminance(pixel);
        squares += luminance(pixel) * luminance(pixel);
    }
    const auto count = static_cast<double>(picture.pixels().size());
    return {sum / count, std::sqrt(squares) / count};
}

std::vector<CaseRow> both_ways(const ChapterRun& run) {
    const Scene scene = read_scene(run.scene);
    const auto list = make_accelerator("list", scene);
    const CameraFrame frame = camera_frame(scene.camera, {160, 120}, scene.source);
    const ForwardOptions options{.eye_radius = 0.5,
                                 .light_rays = run.sized<std::uint64_t>(1000000, 250000),
                                 .longest_path = 2,  // light, surface, eye: the paths of the backward picture
                                 .seed = run.seed,
                                 .threads = run.threads};
    const Brightness forward = brightness(trace_forward(scene, *list, frame, options).picture);
    const double backward = brightness(trace_backward(scene, *list, frame, 2, run.threads).picture).mean;
    const double off = std::abs(forward.mean - backward) / forward.deviation;
    return {{"forward against backward, mean brightness", "holds: within 4 standard deviations",
             fmt::format("{:.3g} +- {:.2g} against {:.3g}: {:.1f}", forward.mean, forward.deviation, backward, off),
             off <= 4}};
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    std::vector<StabilityCase> all = camera_cases();
    all.push_back({"HALF-PIXEL",
                   "A ray through a pixel's corner shows what is half a pixel away: the whole picture is shifted.",
                   half_pixel});
    all.push_back({"PINHOLE", "A point has no area: of all rays that leave the light none ever hits it.",
                   [run] { return pinhole(run); }});
    all.push_back({"BOTH-WAYS", "Light followed either way is the same light, given the same paths.",
                   [run] { return both_ways(run); }});
    all.push_back(sample_slope(run));
    return all;
}

}  // namespace raylab::ray_generation
