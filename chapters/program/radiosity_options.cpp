#include "radiosity_options.h"

#include "memory_words.h"
#include "picture_words.h"

#include "raylab/base/common_options.h"

#include <fmt/format.h>

#include <utility>

namespace raylab {

namespace {

const CommandLine command_line_of_radiosity = with_memory_option(
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
         {"--walk", "FILE.html", "a page in which one walks through the solved scene, in any browser"},
         {"--json", "FILE", "patches, row sums, power, iterations, seconds as JSON; - is standard output"},
         {"--system", "FILE.json", "solve {area, emission, reflectance, F} instead of a scene"},
         {"--error", "E",
          "of the picture, relative to its mean: choose mesh and method so that it is at most that. Instead of --mesh"},
         {"--mesh", "WORD",
          "uniform: patches of one size; adaptive: quartered where the light changes; hierarchical: links between pieces",
          "uniform"},
         {"--edge", "METRES", "the longest side of a patch; adaptive, hierarchical: of the smallest"},
         {"--patches", "N", "the same by a number: the edge of as many equal patches as possible, but at most N",
          "1000"},
         {"--tolerance", "T",
          "of the mean radiosity: adaptive: a difference in a patch (0.1), hierarchical: a link's error (0.02)"},
         {"--lines", "WORD", "contact: surfaces are cut where others stand on them; none", "none"},
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
         {"--exposure", "X", "glTF, walk: colours are radiance times X (default: a twentieth of the area is white)"},
         {"--cache", "DIR", "keep form factors, links and solution there, and reuse what is still true"},
         threads_option()}});

}  // namespace

void refuse_matrix_options(const Arguments& arguments) {
    for (const auto& [option, fallback] :
         {std::pair{"--form-factors", "auto"}, std::pair{"--rows", "symmetric"}, std::pair{"--solver", "auto"}})
        if (arguments.text(option) != fallback)
            throw Error(fmt::format(
                "expected {} with --mesh uniform or adaptive, found it with hierarchical, which has no matrix",
                option));
    if (arguments.has("--ambient-estimate"))
        throw Error("expected --ambient-estimate with --mesh uniform or adaptive, found it with hierarchical");
}

const CommandLine& radiosity_command_line() { return command_line_of_radiosity; }

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

SceneRadiosityOptions radiosity_options(const Arguments& arguments) {
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
    options.before_memory = say_memory;
    return options;
}

double tolerance_or(double fallback, const Arguments& arguments) {
    return arguments.has("--tolerance") ? positive(arguments, "--tolerance") : fallback;
}

SceneHierarchyOptions hierarchy_options(const Arguments& arguments) {
    const SceneRadiosityOptions of_matrix = radiosity_options(arguments);
    return {.edge = of_matrix.edge,
            .patches = of_matrix.patches,
            .lines = of_matrix.lines,
            .solving = {.error = tolerance_or(0.02, arguments),
                        .rays = of_matrix.form_factors.rays,
                        .light_points = of_matrix.light_points,
                        .residual = of_matrix.solving.residual,
                        .threads = of_matrix.form_factors.threads,
                        .limit = of_matrix.limit,
                        .before_memory = of_matrix.before_memory}};
}

}  // namespace raylab
