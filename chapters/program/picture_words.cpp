#include "picture_words.h"

#include "memory_words.h"
#include "recursion_end.h"

#include "raylab/base/error.h"
#include "raylab/scene/memory_need.h"
#include "raylab/scene/nff/spd_sides.h"
#include "raylab/scene/read_scene.h"
#include "raylab/scene/render_model.h"
#include "raylab/tracer/picture/only_needed.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace raylab {

namespace {

enum class RayRules {
    lab,
    // Follows every ray that the surfaces call for, whatever its throughput; light is computed on outer sides only.
    spd,
};

constexpr int most_per_side = 1024;  // 2^20 rays for a pixel

constexpr int spd_depth = 5;  // the databases' own limit

// Camera rays through every corner of the scene's pixels: those are the pixel centers of a picture one pixel larger in
// each direction.
CameraFrame frame_of_corners(const CameraFrame& frame) {
    CameraFrame corners = frame;
    corners.image = {frame.image.width + 1, frame.image.height + 1};
    corners.half_width *= 1.0 * corners.image.width / frame.image.width;
    corners.half_height *= 1.0 * corners.image.height / frame.image.height;
    return corners;
}

BufferUse buffer_use(const Arguments& arguments, const std::string& option) {
    const std::string word = arguments.text(option);
    if (word == "always") return BufferUse::always;
    if (word == "never") return BufferUse::never;
    if (word == "auto") return BufferUse::where_it_pays;
    throw Error("expected " + option + " always, never or auto, found \"" + word + "\"");
}

WhittedOptions whitted_options(const Arguments& arguments, const Scene& scene, RayRules rules) {
    const auto& viewer = arguments.text("--viewer");
    if (viewer != "local" && viewer != "infinity")
        throw Error("expected --viewer local or infinity, found \"" + viewer + "\"");
    const auto [depth, threshold] = recursion_end(arguments, {.threshold = "--threshold"});
    if (!(threshold >= 0 && threshold < 1))
        throw Error("expected --threshold from 0 to below 1, found " + arguments.text("--threshold"));
    WhittedOptions options{
        .depth = depth, .threshold = threshold, .start = ray_start_from_words(arguments.text("--offset"))};
    if (rules == RayRules::spd) {
        if (!arguments.has("--depth")) options.depth = spd_depth;
        options.threshold = -1;
        options.lit = WhittedOptions::Lit::outer_side;
    }
    if (arguments.has("--fresnel")) options.reflectance = WhittedOptions::Reflectance::fresnel;
    if (viewer == "infinity") {
        options.viewer = WhittedOptions::Viewer::at_infinity;
        options.to_viewer = -camera_frame(scene.camera, scene.image, scene.source).forward;
    }
    return options;
}

// Whitted's model has no other samples than those of a grid.
int samples_per_side(const Arguments& arguments) {
    const int samples = asked_samples(arguments, 1);
    const int per_side = static_cast<int>(std::lround(std::sqrt(samples)));
    if (per_side * per_side != samples)
        throw Error(
            fmt::format("expected --samples NxN (or a square: 1, 4, 9, ...) for Whitted's model, found {}", samples));
    return per_side;
}

std::vector<std::size_t> numbers_up_to(std::size_t count) {
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
}

}  // namespace

ImageSize size_from_words(const std::string& words) {
    const auto size = two_integers(words, 'x');
    if (!size) throw Error("expected --size WIDTHxHEIGHT in pixels, found \"" + words + "\"");
    return {(*size)[0], (*size)[1]};
}

CommandLine with_picture_options(CommandLine command_line) {
    command_line.options.insert(
        command_line.options.end(),
        {{"--size", "WIDTHxHEIGHT", "the size in pixels (default: the scene's)"},
         {"--model", "NAME",
          "how light is followed: auto, whitted, distributed, path (default: the scene's; auto: distributed where a "
          "lens, motion, gloss, roughness or emission spreads rays)"},
         {"--samples", "N", "rays for each pixel, or NxN: a jittered grid (default: 1; 16 where rays are spread)"},
         {"--depth", "N",
          "the greatest depth of the ray tree; the eye ray has depth 1 (default: what `raylab needs` says; any where rays are "
          "spread)"},
         {"--threshold", "SHARE",
          "a ray that can add no more than this share to the pixel is not followed (default: 1/256, with --depth 0)"},
         {"--fresnel", "", "transmitting surfaces divide light by the angle (Fresnel), not by kr and kt"},
         {"--viewer", "WHERE", "the viewer of highlights: local, infinity", "local"},
         {"--offset", "HOW", "how rays leave a surface: error_bounded, none, fixed:METRES, scaled:SHARE",
          "error_bounded"},
         {"--spd", "", "use the rules of the Standard Procedural Databases: a ray through each pixel corner"},
         {"--accelerator", "NAME", "the structure that finds hits: " + accelerator_list(), "auto"},
         {"--light-buffer", "WHEN",
          "first list the primitives that may occlude each light: always, never, auto (where shadow rays are many)",
          "never"},
         {"--item-buffer", "WHEN",
          "first draw the primitives that may be visible in each pixel: always, never, auto (where it pays)", "auto"}});
    return with_memory_option(command_line);
}

int asked_samples(const Arguments& arguments, int otherwise) {
    if (!arguments.has("--samples")) return otherwise;
    const std::string& words = arguments.text("--samples");
    if (const auto grid = two_integers(words, 'x')) {
        if ((*grid)[0] == (*grid)[1] && (*grid)[0] >= 1 && (*grid)[0] <= most_per_side) return (*grid)[0] * (*grid)[1];
        throw Error(fmt::format("expected --samples NxN, N from 1 to {}, found \"{}\"", most_per_side, words));
    }
    return static_cast<int>(arguments.integer("--samples", 1, most_per_side * most_per_side));
}

AskedScene asked_scene(const Arguments& arguments, Outputs& outputs) {
    const MemoryLimit limit = memory_limit(arguments);
    Scene scene = read_scene(arguments.text("SCENE"), limit);
    outputs.keep(scene.files_read);
    if (arguments.has("--size")) scene.image = size_from_words(arguments.text("--size"));
    if (const auto word = arguments.text_if_given("--model")) {
        const auto model = render_model(*word);
        if (!model) throw Error("expected --model auto, whitted, distributed or path, found \"" + *word + "\"");
        scene.model = *model;
    }
    const bool spd = arguments.has("--spd");
    if (spd && arguments.has("--model") && scene.model != RenderModel::whitted)
        throw Error("expected --model whitted with --spd, whose rules are of that model, found --model " +
                    arguments.text("--model"));
    scene.model = spd ? RenderModel::whitted : chosen_model(scene);
    return {std::move(scene), limit};
}

void refuse_whitted_words(const Arguments& arguments) {
    const std::pair<const char*, const char*> options[] = {
        {"--threshold", ""}, {"--viewer", "local"}, {"--light-buffer", "never"}, {"--item-buffer", "auto"}};
    for (const auto& [option, fallback] : options)
        if (arguments.has(option) && arguments.text(option) != fallback)
            throw Error(fmt::format("expected --model whitted with {} {}, found a model that spreads rays", option,
                                    arguments.text(option)));
}

AskedPicture asked_picture(const Arguments& arguments, AskedScene asked) {
    auto& [scene, limit] = asked;
    const bool spd = arguments.has("--spd");
    const int per_side = samples_per_side(arguments);
    WhittedOptions options = whitted_options(arguments, scene, spd ? RayRules::spd : RayRules::lab);
    std::vector<std::size_t> lights = numbers_up_to(scene.lights.size());
    if (spd) {
        scene = with_spd_sides(scene);
    } else {
        lights = seen_lights(scene, options);
        scene = with_lights(std::move(scene), lights);
        options = only_needed(scene, options);
    }
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    return {.scene = std::move(scene),
            .lights = std::move(lights),
            .options = options,
            .frame = spd ? frame_of_corners(frame) : frame,
            .samples = {per_side == 1 ? SamplePattern::center : SamplePattern::jittered, per_side},
            .limit = limit};
}

std::string recursion_words(const AskedPicture& picture) {
    return in_words(RecursionEnd{picture.options.depth, picture.options.threshold});
}

std::string choice_words(const Arguments& arguments, const Scene& scene, const std::string& chosen) {
    if (arguments.text("--accelerator") != "auto" || chosen == suited_accelerator(scene)) return "";
    return chosen + " finds the hits: so many rays pay for its longer build\n";
}

PictureAccelerator picture_accelerator(const Arguments& arguments, const AskedPicture& picture, int build_threads) {
    return {arguments.text("--accelerator"),
            picture.scene,
            picture.frame,
            picture.options,
            picture.samples,
            buffer_use(arguments, "--item-buffer"),
            buffer_use(arguments, "--light-buffer"),
            {.threads = build_threads}};
}

}  // namespace raylab
