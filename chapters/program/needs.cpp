#include "commands.h"
#include "memory_words.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/report/json_text.h"
#include "raylab/scene/needs.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

const CommandLine needs_command_line = with_memory_option(
    {.program = "raylab needs",
     .about = "Tells what a picture of SCENE needs, from the scene alone: which light paths it has, what must be "
              "modelled for\n"
              "them, what is left out and why, and what Whitted's method and radiosity do not show.",
     .positionals = {{"SCENE", "the scene (.toml or .nff)"}},
     .options = {
         {"--threshold", "X", "a ray that can add no more than this share to the pixel is not followed", "0.00390625"},
         {"--depth", "N", "the depth at which recursion ends if no threshold ends it; the eye ray has depth 1", "32"},
         {"--fresnel", "", "transmitting surfaces divide light by the angle (Fresnel), not by kr and kt"},
         {"--json", "FILE", "the answer as JSON; - is standard output"}}});

double threshold_of(const Arguments& arguments) {
    const double threshold = arguments.number("--threshold");
    if (!(threshold >= 0 && threshold < 1))
        throw Error(fmt::format("expected a number from 0 to below 1 for --threshold, found {}", threshold));
    return threshold;
}

nlohmann::ordered_json radiosity_json(const Scene& scene) {
    const auto refused = refused_by_radiosity(scene);
    nlohmann::ordered_json json{{"can_solve", !refused}, {"not_shown", beyond_radiosity(scene)}};
    if (refused) json["refused"] = *refused;
    return json;
}

std::string radiosity_words(const Scene& scene) {
    if (const auto refused = refused_by_radiosity(scene)) return "radiosity cannot solve it: " + *refused + "\n";
    const auto missing = beyond_radiosity(scene);
    if (missing.empty()) return "radiosity shows all of it\n";
    std::string text = "radiosity would leave out:\n";
    for (const std::string& one : missing) text += "  " + one + "\n";
    return text;
}

}  // namespace

ExitCode needs_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(needs_command_line, words);
    const NeedsOptions options{
        .threshold = threshold_of(arguments),
        .depth_limit = static_cast<int>(arguments.integer("--depth", 1, 1000)),
        .split = arguments.has("--fresnel") ? NeedsOptions::Split::by_angle : NeedsOptions::Split::as_given};
    Outputs outputs({.files = arguments.given({"--json"}), .inputs = arguments.given({"SCENE"})});
    const Scene scene = read_scene(arguments.text("SCENE"), memory_limit(arguments));
    outputs.keep(scene.files_read);
    const Needs needs = needs_of(scene, options);
    const auto json = arguments.text_if_given("--json");
    auto answer = to_json(needs, scene);
    answer["radiosity"] = radiosity_json(scene);
    if (json) write_json(json_text(answer), outputs[*json]);
    if (json != "-") outputs.say(to_text(needs, scene) + radiosity_words(scene));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
