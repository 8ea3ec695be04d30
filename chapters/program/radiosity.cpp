#include "commands.h"
#include "memory_words.h"
#include "picture_words.h"
#include "radiosity_words.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/base/read_json.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_name.h"
#include "raylab/radiosity/adaptive_radiosity.h"
#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/radiosity/solve/ambient_estimate.h"
#include "raylab/radiosity/solve/solution_json.h"
#include "raylab/radiosity/system/read_system.h"
#include "raylab/radiosity/vertex_radiosity.h"
#include "raylab/report/json_text.h"
#include "raylab/report/radiosity/patch_table.h"
#include "raylab/report/radiosity/radiosity_gltf.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>
#include <utility>

namespace raylab {

namespace {

const CommandLine radiosity_command_line = with_memory_option(
    {.program = "raylab radiosity",
     .about =
         "Computes the light between the diffuse surfaces of SCENE once, and shows it from anywhere. --system solves a "
         "system\ngiven as numbers instead.",
     .positionals = {{"SCENE", "the scene (.toml or .nff)", Positional::Count::optional}},
     .options = {
         {"-o,--output", "IMAGE", "the scene's camera's picture: .exr (linear floats) or .png"},
         {"--table", "FILE.csv", "a row for each patch: place, area, emission, reflectance, radiosity"},
         {"--vertices", "FILE.csv", "a row for each vertex: place, radiosity"},
         {"--gltf", "FILE.glb", "the solved scene for any viewer: glTF 2.0, colours at vertices"},
         {"--json", "FILE", "patches, row sums, power, iterations, seconds as JSON; - is standard output"},
         {"--system", "FILE.json", "solve {area, emission, reflectance, F} instead of a scene"},
         {"--mesh", "WORD",
          "uniform: patches of one size; adaptive: quartered where the light changes; hierarchical: links between pieces",
          "uniform"},
         {"--edge", "METRES", "the longest side of a patch; adaptive, hierarchical: of the smallest"},
         {"--patches", "N", "the same by a number: the edge of as many equal patches as possible, but at most N",
          "1000"},
         {"--error", "E",
          "of the mean radiosity: adaptive: a difference in a patch (0.1), hierarchical: a link (0.02)"},
         {"--lines", "WORD", "contact: surfaces are cut where others stand on them; none (of hierarchical always)",
          "none"},
         {"--form-factors", "METHOD", "auto, or one of the methods of form factors that chapter 14 compares", "auto"},
         {"--resolution", "N", "the effort of that method: pixels of a hemicube along an edge, pairs of points, ..."},
         {"--visibility", "WORD", "exact: shadow rays; none: nothing hides anything", "exact"},
         {"--rays", "N", "shadow rays for a pair of patches that face each other", "8"},
         {"--rows", "WORD", "symmetric: rows of form factors are scaled to at most 1; raw: as computed", "symmetric"},
         {"--solver", "NAME", "auto, elimination, cholesky, jacobi, gauss_seidel, relaxation or shooting", "auto"},
         {"--ambient-estimate", "", "show what shooting has not shot yet as if it were spread evenly"},
         {"--iterations", "N", "a solver's largest number of iterations", "1000000"},
         {"--residual", "R", "the residual at which a solver ends", "1e-9"},
         {"--show", "WORD", "patches, vertices (interpolated) or gather (computed at each point)", "vertices"},
         {"--camera", "SCENE", "take the camera of another scene"},
         {"--size", "WxH", "the size of the picture instead of the scene's"},
         {"--samples", "N", "N x N rays a pixel", "3"},
         {"--exposure", "X", "glTF: colours are radiance times X (default: a twentieth of the area is white)"},
         {"--threads", "N", "the number of threads (default: all cores)"}}});

template <class Value>
Value one_of(const Arguments& arguments, const std::string& option, const std::map<std::string, Value>& known) {
    const std::string& word = arguments.text(option);
    if (const auto found = known.find(word); found != known.end()) return found->second;
    std::string names;
    for (const auto& [name, value] : known) names += (names.empty() ? "" : ", ") + name;
    throw Error("expected " + option + " to be one of " + names + ", found \"" + word + "\"");
}

double positive(const Arguments& arguments, const std::string& option) {
    const double value = arguments.number(option);
    if (!(value > 0)) throw Error(fmt::format("expected a number over 0 for {}, found {}", option, value));
    return value;
}

SolverOptions solver_options(const Arguments& arguments) {
    return {.residual = positive(arguments, "--residual"),
            .iterations = static_cast<int>(arguments.integer("--iterations", 1, 1'000'000'000)),
            .threads = threads_of(arguments),
            .limit = memory_limit(arguments)};
}

SceneRadiosityOptions options_from(const Arguments& arguments) {
    SceneRadiosityOptions options;
    if (arguments.has("--edge")) options.edge = positive(arguments, "--edge");
    options.patches = static_cast<std::size_t>(arguments.integer("--patches", 1, 1'000'000));
    options.form_factors = {
        .method = arguments.text("--form-factors"),
        .rays = one_of<bool>(arguments, "--visibility", {{"exact", true}, {"none", false}})
                    ? static_cast<int>(arguments.integer("--rays", 1, 1'000'000))
                    : 0,
        .effort = arguments.has("--resolution") ? static_cast<int>(arguments.integer("--resolution", 1, 4096)) : 0,
        .threads = threads_of(arguments),
        .label = "form factors"};
    options.lines =
        one_of<MeshLines>(arguments, "--lines", {{"none", MeshLines::none}, {"contact", MeshLines::contact}});
    using Rows = SceneRadiosityOptions::Rows;
    options.rows = one_of<Rows>(arguments, "--rows", {{"symmetric", Rows::symmetric}, {"raw", Rows::raw}});
    options.solver = arguments.text("--solver");
    options.solving = solver_options(arguments);
    options.limit = memory_limit(arguments);
    return options;
}

// Replaces the radiosities by those with the ambient estimate: for the picture, the tables and the model alike.
void add_ambient_estimate(SceneRadiosity& solved) {
    if (solved.solution.unshot.empty())
        throw Error("expected --ambient-estimate with --solver shooting, found " + solved.solution.solver);
    solved.solution.radiosity = with_ambient_estimate(solved.system, solved.solution.radiosity, solved.solution.unshot);
    solved.vertices = vertex_radiosities(*solved.mesh, solved.solution.radiosity);
}

Image picture_of(const Arguments& arguments, const Scene& scene, const RadiosityView& view) {
    using Shading = RadiosityShading;
    const auto shading =
        one_of<Shading>(arguments, "--show",
                        {{"patches", Shading::patches}, {"vertices", Shading::vertices}, {"gather", Shading::gather}});
    const EyePictureOptions options{.samples = {.per_side = static_cast<int>(arguments.integer("--samples", 1, 256))},
                                    .threads = threads_of(arguments),
                                    .label = "picture"};
    return radiosity_picture(view, camera_frame(scene.camera, scene.image, scene.source), shading, options);
}

ExitCode solve_numbers(const Arguments& arguments, Outputs& outputs) {
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

void write(const Answer& answer, const Arguments& arguments, const Scene& scene, Outputs& outputs) {
    const SolvedScene& solved = answer.solved;
    const auto output = arguments.text_if_given("--output"), json = arguments.text_if_given("--json");
    if (const auto file = arguments.text_if_given("--table")) outputs.write(*file, patch_table(solved));
    if (const auto file = arguments.text_if_given("--vertices")) outputs.write(*file, vertex_table(solved));
    if (const auto file = arguments.text_if_given("--gltf"))
        outputs.write(*file, radiosity_gltf(solved, arguments.has("--exposure") ? positive(arguments, "--exposure")
                                                                                : exposure_for(solved)));
    if (json) write_json(json_text(answer.json), outputs[*json]);
    if (json != "-") {
        outputs.say(answer.words);
        for (const std::string& missing : beyond_radiosity(scene)) outputs.say("not shown: " + missing + "\n");
    }
    if (output) write_image(picture_of(arguments, scene, answer.view), outputs[*output]);
}

double error_or(double fallback, const Arguments& arguments) {
    return arguments.has("--error") ? positive(arguments, "--error") : fallback;
}

void solve_with_matrix(const Arguments& arguments, const Scene& scene, Outputs& outputs) {
    const SceneRadiosityOptions options = options_from(arguments);
    const bool adapts = arguments.text("--mesh") == "adaptive";
    if (!adapts && arguments.has("--error"))
        throw Error("expected --error with --mesh adaptive or hierarchical, found it with uniform");
    SceneRadiosity solved =
        adapts ? adaptive_radiosity(scene, options, error_or(0.1, arguments)) : scene_radiosity(scene, options);
    if (arguments.has("--ambient-estimate")) add_ambient_estimate(solved);
    write({{*solved.mesh, solved.system.reflectance, solved.solution.radiosity, solved.vertices},
           solved.view(),
           radiosity_json(solved, options.solving),
           radiosity_words(solved)},
          arguments, scene, outputs);
}

// The options that ask something of the whole matrix, and what they say if nothing is asked.
void refuse_matrix_options(const Arguments& arguments) {
    for (const auto& [option, fallback] : {std::pair{"--form-factors", "auto"}, std::pair{"--rows", "symmetric"},
                                           std::pair{"--solver", "auto"}, std::pair{"--lines", "none"}})
        if (arguments.text(option) != fallback)
            throw Error(fmt::format(
                "expected {} with --mesh uniform or adaptive, found it with hierarchical, which has no matrix",
                option));
    if (arguments.has("--ambient-estimate"))
        throw Error("expected --ambient-estimate with --mesh uniform or adaptive, found it with hierarchical");
}

void solve_with_hierarchy(const Arguments& arguments, const Scene& scene, Outputs& outputs) {
    refuse_matrix_options(arguments);
    const SceneRadiosityOptions of_matrix = options_from(arguments);
    const SceneHierarchyOptions options{.edge = of_matrix.edge,
                                        .patches = of_matrix.patches,
                                        .solving = {.error = error_or(0.02, arguments),
                                                    .rays = of_matrix.form_factors.rays,
                                                    .light_points = of_matrix.light_points,
                                                    .residual = of_matrix.solving.residual,
                                                    .threads = of_matrix.form_factors.threads,
                                                    .limit = of_matrix.limit}};
    const SceneHierarchy solved = scene_hierarchy(scene, options);
    write({{*solved.mesh, solved.reflectance, solved.patches, solved.vertices},
           solved.view(),
           radiosity_json(solved),
           radiosity_words(solved)},
          arguments, scene, outputs);
}

}  // namespace

ExitCode radiosity_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(radiosity_command_line, words);
    const std::vector<std::string> files{"--output", "--table", "--vertices", "--gltf", "--json"};
    Outputs outputs({.files = arguments.given(files), .inputs = arguments.given({"SCENE", "--system", "--camera"})});
    if (arguments.has("SCENE") == arguments.has("--system"))
        throw Error("expected either SCENE or --system FILE.json, found " +
                    std::string(arguments.has("SCENE") ? "both" : "neither"));
    if (arguments.has("--system")) return solve_numbers(arguments, outputs);
    if (const auto output = arguments.text_if_given("--output")) check_picture_name(*output);

    const Scene scene = asked_diffuse_scene(arguments, outputs);
    one_of<decltype(&solve_with_matrix)>(
        arguments, "--mesh",
        {{"uniform", solve_with_matrix}, {"adaptive", solve_with_matrix}, {"hierarchical", solve_with_hierarchy}})(
        arguments, scene, outputs);
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
