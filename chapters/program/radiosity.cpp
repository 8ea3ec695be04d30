#include "commands.h"
#include "memory_words.h"
#include "picture_words.h"
#include "radiosity_options.h"
#include "radiosity_words.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/interrupt.h"
#include "raylab/base/outputs.h"
#include "raylab/base/read_json.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_name.h"
#include "raylab/radiosity/adaptive_radiosity.h"
#include "raylab/radiosity/picture_error.h"
#include "raylab/radiosity/radiosity_within.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/radiosity/solve/ambient_estimate.h"
#include "raylab/radiosity/solve/solution_json.h"
#include "raylab/radiosity/system/read_system.h"
#include "raylab/radiosity/vertex_radiosity.h"
#include "raylab/report/json_text.h"
#include "raylab/report/radiosity/patch_table.h"
#include "raylab/report/radiosity/radiosity_gltf.h"
#include "raylab/report/radiosity/walk_through.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <utility>

namespace raylab {

namespace {

// Replaces the radiosities by those with the ambient estimate: for the picture, the tables and the model alike.
void add_ambient_estimate(SceneRadiosity& solved) {
    solved.solution.radiosity = with_ambient_estimate(solved.system, solved.solution.radiosity, solved.solution.unshot);
    solved.vertices = vertex_radiosities(*solved.mesh, solved.solution.radiosity);
}

/// How a solved scene is shown; read before it is solved, which takes time.
struct Showing {
    RadiosityShading shading;
    EyePictureOptions picture;
    std::optional<double> exposure;
};

Showing asked_showing(const Arguments& arguments) {
    using Shading = RadiosityShading;
    return {.shading = one_of<Shading>(
                arguments, "--show",
                {{"patches", Shading::patches}, {"vertices", Shading::vertices}, {"gather", Shading::gather}}),
            .picture = {.samples = {.per_side = static_cast<int>(arguments.integer("--samples", 1, 256))},
                        .threads = threads_of(arguments),
                        .label = "picture"},
            .exposure = arguments.has("--exposure") ? std::optional(positive(arguments, "--exposure")) : std::nullopt};
}

/// A scene, and how it is to be shown.
struct AskedRadiosity {
    Scene scene;
    Showing showing;
};

void refuse_scene_outputs(const Arguments& arguments) {
    for (const char* option : {"--output", "--table", "--vertices", "--gltf", "--walk"})
        if (arguments.has(option))
            throw Error(fmt::format("expected {} with SCENE, found it with --system, which has no surfaces", option));
}

ExitCode solve_numbers(const Arguments& arguments, Outputs& outputs) {
    refuse_scene_outputs(arguments);
    const RadiositySystem system = read_system(arguments.text("--system"), memory_limit(arguments));
    const SolverOptions options = solver_options(arguments);
    const Solution solution = solve(system, solver_named(arguments.text("--solver")), options);
    auto json = solution_json(system, solution, options);
    json["radiosity"] = radiosities_json(solution.radiosity);
    if (const auto file = arguments.text_if_given("--json"))
        write_json(json_text(json), outputs[*file]);
    else
        for (const Color& b : solution.radiosity) outputs.say(fmt::format("{} {} {}\n", b.r, b.g, b.b));
    outputs.commit();
    return ExitCode::as_it_should_be;
}

// The scene with the camera and the size that the options ask for.
Scene asked_diffuse_scene(const Arguments& arguments, Outputs& outputs) {
    Scene scene = read_scene(arguments.text("SCENE"), memory_limit(arguments));
    outputs.keep(scene.files_read);
    if (const auto other = arguments.text_if_given("--camera"))
        scene.camera = read_scene(*other, memory_limit(arguments)).camera;
    if (const auto words = arguments.text_if_given("--size")) scene.image = size_from_words(*words);
    return scene;
}

/// What the command tells of a solved scene, by whatever mesh.
struct Answer {
    SolvedScene solved;
    RadiosityView view;
    nlohmann::ordered_json json;
    std::string words;
};

void write(const Answer& answer, const Arguments& arguments, const AskedRadiosity& asked, Outputs& outputs) {
    const auto& [scene, showing] = asked;
    const SolvedScene& solved = answer.solved;
    const auto output = arguments.text_if_given("--output"), json = arguments.text_if_given("--json");
    if (const auto file = arguments.text_if_given("--table")) outputs.write(*file, patch_table(solved));
    if (const auto file = arguments.text_if_given("--vertices")) outputs.write(*file, vertex_table(solved));
    const auto exposure = [&] { return showing.exposure ? *showing.exposure : exposure_for(solved); };
    if (const auto file = arguments.text_if_given("--gltf")) outputs.write(*file, radiosity_gltf(solved, exposure()));
    if (const auto file = arguments.text_if_given("--walk"))
        outputs.write(*file, walk_through_page(solved, scene.camera,
                                               std::filesystem::path(scene.source).stem().string(), exposure()));
    if (json) write_json(json_text(answer.json), outputs[*json]);
    if (json != "-") {
        outputs.say(answer.words);
        for (const std::string& missing : beyond_radiosity(scene)) outputs.say("not shown: " + missing + "\n");
    }
    if (!output) return;
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    write_image(radiosity_picture(answer.view, frame, showing.shading, showing.picture), outputs[*output]);
}

Answer answer_of(const SceneRadiosity& solved, const PictureError& error, const SceneRadiosityOptions& options) {
    return {{*solved.mesh, solved.system.reflectance, solved.solution.radiosity, solved.vertices},
            solved.view(),
            with_error(radiosity_json(solved, options), error),
            radiosity_words(solved) + cache_words(solved, options.cache) + error_words(error)};
}

Answer answer_of(const SceneHierarchy& solved, const PictureError& error, const RadiosityCache* cache) {
    return {{*solved.mesh, solved.reflectance, solved.patches, solved.vertices},
            solved.view(),
            with_error(radiosity_json(solved, cache), error),
            radiosity_words(solved) + cache_words(solved, cache) + error_words(error)};
}

/// The options of the matrix, with the cache that they name.
struct MatrixOptions {
    explicit MatrixOptions(const Arguments& arguments) : options(radiosity_options(arguments)) {
        if (const auto folder = arguments.text_if_given("--cache")) options.cache = &cache.emplace(*folder);
    }
    MatrixOptions(const MatrixOptions&) = delete;

    std::optional<RadiosityCache> cache = {};
    SceneRadiosityOptions options;  // they point to the cache
};

void solve_with_matrix(const Arguments& arguments, const AskedRadiosity& asked, Outputs& outputs) {
    const MatrixOptions matrix(arguments);
    const bool adapts = arguments.text("--mesh") == "adaptive";
    if (!adapts && arguments.has("--tolerance"))
        throw Error("expected --tolerance with --mesh adaptive or hierarchical, found it with uniform");
    if (const auto& solver = arguments.text("--solver"); arguments.has("--ambient-estimate") && solver != "shooting")
        throw Error("expected --ambient-estimate with --solver shooting, found " + solver);
    SceneRadiosity solved = adapts ? adaptive_radiosity(asked.scene, matrix.options, tolerance_or(0.1, arguments))
                                   : scene_radiosity(asked.scene, matrix.options);
    if (arguments.has("--ambient-estimate")) add_ambient_estimate(solved);
    const PictureError error = picture_error(solved.view(), threads_of(arguments));
    write(answer_of(solved, error, matrix.options), arguments, asked, outputs);
}

void solve_with_hierarchy(const Arguments& arguments, const AskedRadiosity& asked, Outputs& outputs) {
    refuse_matrix_options(arguments);
    std::optional<RadiosityCache> cache;
    SceneHierarchyOptions options = hierarchy_options(arguments);
    if (const auto folder = arguments.text_if_given("--cache")) options.cache = &cache.emplace(*folder);
    const SceneHierarchy solved = scene_hierarchy(asked.scene, options);
    const PictureError error = picture_error(solved.view(), threads_of(arguments));
    write(answer_of(solved, error, options.cache), arguments, asked, outputs);
}

void solve_within_error(const Arguments& arguments, const AskedRadiosity& asked, Outputs& outputs) {
    for (const char* option : {"--edge", "--tolerance", "--ambient-estimate"})
        if (arguments.has(option))
            throw Error(fmt::format("expected {} without --error, which chooses the mesh, found both", option));
    const MatrixOptions matrix(arguments);
    SceneHierarchyOptions of_links = hierarchy_options(arguments);
    of_links.cache = matrix.options.cache;
    const RadiosityWithin within =
        radiosity_within(asked.scene, positive(arguments, "--error"), matrix.options, of_links);
    const auto* equal = std::get_if<SceneRadiosity>(&within.solved);
    Answer answer = equal ? answer_of(*equal, within.error, matrix.options)
                          : answer_of(std::get<SceneHierarchy>(within.solved), within.error, of_links.cache);
    answer.json["attempts"] = attempts_json(within);
    answer.words += attempts_words(within);
    write(answer, arguments, asked, outputs);
}

// What an interrupt says.
std::string what_is_kept(const Arguments& arguments) {
    const auto cache = arguments.text_if_given("--cache");
    return "raylab: stopped; " +
           (cache ? "what was complete is kept in " + *cache + ": the same command goes on from there\n"
                  : std::string("nothing is kept, since there was no --cache DIR\n"));
}

}  // namespace

ExitCode radiosity_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(radiosity_command_line(), words);
    const std::vector<std::string> files{"--output", "--table", "--vertices", "--gltf", "--walk", "--json"};
    Outputs outputs({.files = arguments.given(files), .inputs = arguments.given({"SCENE", "--system", "--camera"})});
    if (arguments.has("SCENE") == arguments.has("--system"))
        throw Error("expected either SCENE or --system FILE.json, found " +
                    std::string(arguments.has("SCENE") ? "both" : "neither"));
    if (arguments.has("--system")) return solve_numbers(arguments, outputs);
    if (const auto output = arguments.text_if_given("--output")) check_picture_name(*output);

    const Showing showing = asked_showing(arguments);
    const AskedRadiosity asked{asked_diffuse_scene(arguments, outputs), showing};
    const AtInterrupt tells([kept = what_is_kept(arguments)] { std::fputs(kept.c_str(), stderr); });
    const auto by_mesh = one_of<decltype(&solve_with_matrix)>(
        arguments, "--mesh",
        {{"uniform", solve_with_matrix}, {"adaptive", solve_with_matrix}, {"hierarchical", solve_with_hierarchy}});
    (arguments.has("--error") ? solve_within_error : by_mesh)(arguments, asked, outputs);
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
