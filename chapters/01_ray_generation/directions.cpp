#include "directions.h"

#include "light_paths.h"

#include "raylab/image/color.h"
#include "raylab/image/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::ray_generation {

namespace {

constexpr ImageSize small{160, 120};
constexpr int samples_per_side = 2;
constexpr double wide_eye = 0.5;  // in metres; a smaller eye gives no picture at all

// The picture is darkened, because one ray carries so large a share of the light's power that its pixel would be white.
Image dimmed(const Image& dots) {
    float brightest = 1;
    for (const Pixel& pixel : dots.pixels()) brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
    return enlarged(exposed(dots, -std::log2(brightest)), 4);
}

std::string counted(const ForwardResult& result, Fate fate) { return fmt::format("{}", result.share(fate).happened); }

std::vector<std::string> row(double radius, const ForwardResult& result) {
    const Share seen = result.share(Fate::in_picture);
    return {fmt::format("{} m", radius),       counted(result, Fate::left),
            counted(result, Fate::absorbed),   counted(result, Fate::beside_picture),
            counted(result, Fate::in_picture), fmt::format("{:.2g} to {:.2g}", seen.low, seen.high)};
}

}  // namespace

Directions compare_directions(const ChapterRun& run, const Stage& stage) {
    const CameraFrame frame = camera_frame(stage.scene.camera, small, stage.scene.source);
    const auto forward = [&](double eye_radius, std::uint64_t light_rays) {
        const ForwardOptions options{
            .eye_radius = eye_radius, .light_rays = light_rays, .seed = run.seed, .threads = run.threads};
        return trace_forward(stage.scene, stage.accelerator, frame, options);
    };
    constexpr std::uint64_t eye_rays{small.width * small.height * samples_per_side * samples_per_side};
    Directions result;
    const auto backward = trace_backward(stage.scene, stage.accelerator, frame, samples_per_side, run.threads);
    result.backward = enlarged(backward.picture, 4);
    result.forward = dimmed(forward(wide_eye, eye_rays).picture);

    const std::uint64_t many = run.sized<std::uint64_t>(32, 8) * eye_rays;
    for (const double radius : {0.0, 0.1}) result.fates.push_back(row(radius, forward(radius, many)));
    const ForwardResult wide = forward(wide_eye, many);
    result.fates.push_back(row(wide_eye, wide));
    result.forward_more = dimmed(wide.picture);

    constexpr double pupil = 0.002;  // the radius in daylight
    const double share = wide.share(Fate::in_picture).value() * std::pow(pupil / wide_eye, 2);
    result.fates.push_back({"0.002 m, a pupil", "", "", "", "", fmt::format("{:.2g}, by its area", share)});
    return result;
}

std::vector<std::string> light_ray_header() {
    return {"radius of the eye",   "left for the sky",    "ended on a surface", "hit the eye beside the picture",
            "reached the picture", "share that did, 95 %"};
}

}  // namespace raylab::ray_generation
