#include "commands.h"
#include "picture_words.h"
#include "ray_counts.h"
#include "transport_render.h"
#include "transport_words.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/base/printable.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_name.h"
#include "raylab/report/json_text.h"
#include "raylab/scene/memory_need.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

const CommandLine render_command_line = with_sampling_end_options(with_sampler_options(with_picture_options(
    {.program = "raylab render",
     .about = "Draws a scene (.toml or .nff): by Whitted's model, by distributed rays, or by paths.",
     .positionals = {{"SCENE", "the scene"}},
     .options = {{"-o,--output", "IMAGE", "the picture to write: .exr (linear floats) or .png"},
                 threads_option(),
                 {"--json", "FILE", "rays cast and hit, tests, seconds as JSON; - is standard output"}}})));

nlohmann::ordered_json to_json(const WhittedPicture& picture, const WhittedOptions& options, double build_seconds) {
    nlohmann::ordered_json json{{"depth", options.depth}, {"threshold", std::max(options.threshold, 0.0)}};
    json.update(to_json(picture.rays, picture.traversal));
    json.update({{"seconds", picture.seconds}, {"build_seconds", build_seconds}});
    return json;
}

// "wrote a.png: 640 x 480 pixels, 9 rays each, 412 kB"
std::string wrote(const std::string& output, const Image& image, int rays, std::uintmax_t bytes) {
    return fmt::format("wrote {}: {} x {} pixels, {} ray{} each, {:.3g} {}\n", printable(output), image.width(),
                       image.height(), rays, rays == 1 ? "" : "s",
                       static_cast<double>(bytes) / (bytes < 1'000'000 ? 1e3 : 1e6), bytes < 1'000'000 ? "kB" : "MB");
}

std::string summary(const WhittedPicture& picture) {
    const auto line = [](const char* kind, const CastAndHit& rays, const char* hit_found) {
        return fmt::format("{:10} {:>12} rays, {:>12} {}\n", kind, rays.cast, rays.hit, hit_found);
    };
    const auto& rays = picture.rays;
    return line("primary", rays.primary, "hit") + line("shadow", rays.shadow, "blocked") +
           line("secondary", rays.secondary, "hit") +
           fmt::format("{:.3g} s: {:.4g} rays a second\n", picture.seconds, rate(all_cast(rays), picture.seconds));
}

}  // namespace

ExitCode render_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(render_command_line, words);
    const auto output = arguments.text_if_given("--output"), json = arguments.text_if_given("--json");
    if (!output && !json) throw Error("expected -o IMAGE or --json FILE, found neither");
    if (output) check_picture_name(*output);
    Outputs outputs({.files = arguments.given({"--output", "--json"}), .inputs = arguments.given({"SCENE"})});
    AskedScene scene = asked_scene(arguments, outputs);
    if (scene.scene.model != RenderModel::whitted) return render_transport(arguments, scene, words, outputs);
    refuse_sampler_words(arguments);
    refuse_sampling_end_words(arguments);
    const AskedPicture asked = asked_picture(arguments, std::move(scene));
    check_memory(picture_need(asked.scene, asked.scene.image), asked.limit, {asked.scene.source});
    const EyePictureOptions picture_options{
        .samples = asked.samples, .threads = threads_of(arguments), .label = "rays"};
    const auto begun = std::chrono::steady_clock::now();
    const PictureAccelerator accelerator = picture_accelerator(arguments, asked, threads_of(arguments));
    const double build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const auto picture =
        counted_whitted_picture(asked.scene, accelerator.finds(), asked.frame, asked.options, picture_options);
    if (json) write_json(json_text(to_json(picture, asked.options, build_seconds)), outputs[*json]);
    if (json != "-")
        outputs.say(summary(picture) + recursion_words(asked) + "\n" +
                    choice_words(arguments, asked.scene, accelerator.name()));
    if (output) write_image(picture.image, outputs[*output]);
    if (output && json != "-") outputs.say(wrote(*output, picture.image, asked.samples.count(), outputs.size(*output)));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
