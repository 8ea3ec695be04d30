#include "commands.h"
#include "memory_words.h"
#include "whitted_words.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/image/files.h"
#include "raylab/image/picture_name.h"
#include "raylab/report/json_text.h"
#include "raylab/scene/memory_need.h"
#include "raylab/scene/nff/spd_sides.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/only_needed.h"
#include "raylab/tracer/picture_accelerator.h"
#include "raylab/tracer/whitted_picture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

const CommandLine command_line = with_memory_option(with_whitted_options(
    {.program = "raylab render",
     .about = "Draws a scene (.toml or .nff) with local lighting, hard shadows, reflection and refraction.",
     .positionals = {{"SCENE", "the scene"}},
     .options = {{"-o,--output", "IMAGE", "where the picture goes: .exr (linear floats) or .png"},
                 {"--size", "WIDTHxHEIGHT", "instead of the scene's, pixels"},
                 {"--samples", "N", "N x N rays a pixel, jittered; 1: one through its middle", "1"},
                 {"--accelerator", "NAME", "what finds hits: " + accelerator_list(), "auto"},
                 {"--light-buffer", "WHEN",
                  "list first what may stop rays to each light: always, never, auto (where feelers are many)", "never"},
                 {"--item-buffer", "WHEN",
                  "draw what may be seen through each pixel first: always, never, auto (where it pays)", "auto"},
                 {"--threads", "N", "how many (default: all cores)"},
                 {"--spd", "", "by the rules of the Standard Procedural Databases: a ray through each pixel corner"},
                 {"--json", "FILE", "rays cast and hit, tests, seconds as JSON; - is standard output"}}}));

nlohmann::ordered_json to_json(const CastAndHit& rays) { return {{"cast", rays.cast}, {"hit", rays.hit}}; }

nlohmann::ordered_json to_json(const WhittedPicture& picture, double build_seconds) {
    return {{"primary", to_json(picture.rays.primary)},
            {"shadow", to_json(picture.rays.shadow)},
            {"secondary", to_json(picture.rays.secondary)},
            {"seconds", picture.seconds},
            {"build_seconds", build_seconds},
            {"box_tests", picture.traversal.box_tests},
            {"steps", picture.traversal.steps},
            {"primitive_tests", picture.traversal.primitive_tests},
            {"exact_decisions", picture.traversal.exact_decisions}};
}

std::string summary(const WhittedPicture& picture) {
    const auto line = [](const char* kind, const CastAndHit& rays, const char* met) {
        return fmt::format("{:10} {:>12} rays, {:>12} {}\n", kind, rays.cast, rays.hit, met);
    };
    const auto& rays = picture.rays;
    const auto all = rays.primary.cast + rays.shadow.cast + rays.secondary.cast;
    return line("primary", rays.primary, "hit") + line("shadow", rays.shadow, "blocked") +
           line("secondary", rays.secondary, "hit") +
           fmt::format("{:.3g} s: {:.4g} rays a second\n", picture.seconds, static_cast<double>(all) / picture.seconds);
}

ImageSize size_from(const std::string& words) {
    const auto size = two_integers(words, 'x');
    if (!size) throw Error("expected --size WIDTHxHEIGHT in pixels, found \"" + words + "\"");
    return {(*size)[0], (*size)[1]};
}

// A ray through every corner of the scene's pixels: a picture one pixel larger each way, whose pixels' middles they
// are.
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

}  // namespace

ExitCode render_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(command_line, words);
    const auto output = arguments.text_if_given("--output"), json = arguments.text_if_given("--json");
    if (!output && !json) throw Error("expected -o IMAGE or --json FILE, found neither");
    if (output) check_picture_name(*output);
    Outputs outputs({.files = arguments.given({"--output", "--json"}), .inputs = arguments.given({"SCENE"})});
    const bool spd = arguments.has("--spd");
    const MemoryLimit limit = memory_limit(arguments);
    Scene scene = read_scene(arguments.text("SCENE"), limit);
    outputs.keep(scene.mesh_files);
    if (arguments.has("--size")) scene.image = size_from(arguments.text("--size"));
    check_memory(picture_need(scene, scene.image), limit, {scene.source});
    WhittedOptions options = whitted_options(arguments, scene, spd ? RayRules::spd : RayRules::lab);
    if (spd) {
        scene = with_spd_sides(scene);
    } else {
        scene = without_unseen_lights(std::move(scene), options);
        options = only_needed(scene, options);
    }
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    const auto per_side = static_cast<int>(arguments.integer("--samples", 1, 64));
    const EyePictureOptions picture_options{
        .samples = {per_side == 1 ? SamplePattern::center : SamplePattern::jittered, per_side},
        .threads = arguments.has("--threads") ? static_cast<int>(arguments.integer("--threads", 1, 1024)) : 0,
        .label = "rays"};
    const auto begun = std::chrono::steady_clock::now();
    const CameraFrame rays = spd ? frame_of_corners(frame) : frame;
    const PictureAccelerator accelerator(arguments.text("--accelerator"), scene, rays, options, picture_options.samples,
                                         buffer_use(arguments, "--item-buffer"),
                                         buffer_use(arguments, "--light-buffer"));
    const double build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const auto picture = counted_whitted_picture(scene, accelerator.finds(), rays, options, picture_options);
    if (output) write_image(picture.image, outputs[*output]);
    if (json) write_json(json_text(to_json(picture, build_seconds)), outputs[*json]);
    if (json != "-") outputs.say(summary(picture));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
