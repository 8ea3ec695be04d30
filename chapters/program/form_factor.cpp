#include "commands.h"
#include "memory_words.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/radiosity/object_form_factor.h"
#include "raylab/report/json_text.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <sstream>

namespace raylab {

namespace {

const CommandLine form_factor_command_line = with_memory_option(
    {.program = "raylab form-factor",
     .about =
         "Tells the share of what one object sends out that arrives at another, with what stands between them. An object\n"
         "is named by its path in the scene, as `raylab needs` and ray trees show it: \"polygon 0\", \"pair[2]/sphere "
         "0:back\".",
     .positionals = {{"SCENE", "the scene (.toml or .nff)"}},
     .options = {{"--from", "OBJECT", "what sends light"},
                 {"--from-point", "X,Y,Z", "a small patch at this point instead, with --normal"},
                 {"--normal", "X,Y,Z", "the direction to which that patch looks"},
                 {"--to", "OBJECT", "what receives it"},
                 {"--method", "METHOD", "in full view: polygon, closed, contour, area, hemicube or disk", "polygon"},
                 {"--samples", "N", "shadow rays in all, at least 16 for each pair of flat pieces", "65536"},
                 {"--edge", "METRES", "the longest side of the pieces of a curved surface", "0.1"},
                 {"--json", "FILE", "value, standard error, rays, seconds as JSON; - is standard output"}}});

Vec3d vector_of(const Arguments& arguments, const std::string& option) {
    std::istringstream text(arguments.text(option));
    Vec3d v;
    char first = 0, second = 0;
    if (!(text >> v.x >> first >> v.y >> second >> v.z) || first != ',' || second != ',' || text.get() != EOF)
        throw Error("expected three numbers for " + option + ", such as 0,1.5,-2, found \"" + arguments.text(option) +
                    "\"");
    return v;
}

ObjectFormFactor asked(const Arguments& arguments, const Scene& scene) {
    const SurfaceName to = surface_name(arguments.text("--to"));
    const double edge = arguments.number("--edge");
    const auto samples = static_cast<int>(arguments.integer("--samples", 1, 1'000'000'000));
    if (arguments.has("--from-point") == arguments.has("--from"))
        throw Error("expected either --from OBJECT or --from-point X,Y,Z --normal X,Y,Z");
    if (arguments.has("--from"))
        return object_form_factor(scene, surface_name(arguments.text("--from")), to, edge, samples,
                                  arguments.text("--method"));
    if (arguments.text("--method") != "polygon")
        throw Error("expected --method with --from OBJECT, found it with --from-point, which has the contour integral");
    const Vec3d normal = vector_of(arguments, "--normal");
    if (!(glm::length(normal) > 0)) throw Error("expected --normal to have a length, found 0,0,0");
    return point_form_factor(scene, vector_of(arguments, "--from-point"), normal, to, edge, samples);
}

}  // namespace

ExitCode form_factor_command(const std::vector<std::string>& words) {
    const Arguments arguments = parse(form_factor_command_line, words);
    Outputs outputs({.files = arguments.given({"--json"}), .inputs = arguments.given({"SCENE"})});
    const Scene scene = read_scene(arguments.text("SCENE"), memory_limit(arguments));
    outputs.keep(scene.files_read);
    const auto begun = std::chrono::steady_clock::now();
    const ObjectFormFactor found = asked(arguments, scene);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const auto json = arguments.text_if_given("--json");
    if (json)
        write_json(json_text({{"value", found.value},
                              {"standard_error", found.standard_error},
                              {"method", (arguments.has("--from") ? arguments.text("--method") : "contour") +
                                             ", times the share of shadow rays"},
                              {"rays", found.rays},
                              {"surface_error", found.surface_error},
                              {"seconds", seconds}}),
                   outputs[*json]);
    if (json != "-") {
        outputs.say(fmt::format("{:.12g}\n", found.value));
        if (found.standard_error > 0) outputs.say(fmt::format("standard error {:.2g}\n", found.standard_error));
        if (found.surface_error > 0)
            outputs.say(
                fmt::format("curved surfaces: at most {:.2g} m from their pieces (--edge)\n", found.surface_error));
    }
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
