#include "commands.h"
#include "memory_words.h"
#include "recursion_end.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/scene/pov/write_pov.h"
#include "raylab/scene/read_scene.h"

namespace raylab {

namespace {

const CommandLine export_command_line =
    with_memory_option({.program = "raylab export",
                        .about = "Writes a scene for another renderer: POV-Ray 3.7 (.pov). It prints what POV-Ray will "
                                 "show differently, and why.",
                        .positionals = {{"SCENE", "the scene (.toml, .nff)"}},
                        .options = {{"-o,--output", "FILE", "the file to write; its extension chooses the renderer"},
                                    {"--depth", "N", "the longest path of rays, with the eye ray (default: 32)"},
                                    {"--adc-bailout", "SHARE",
                                     "POV-Ray drops rays with a smaller weight (default: 1/256, with --depth 0)"},
                                    {"--samples", "N", "eye rays through a lens, points of an area light", "64"}}});

PovOptions pov_options(const Arguments& arguments) {
    constexpr int deepest = 256;  // POV-Ray's own limit
    const auto [depth, weight] = recursion_end(arguments, {.threshold = "--adc-bailout", .deepest = deepest});
    const PovOptions options{
        .depth = depth, .adc_bailout = weight, .samples = static_cast<int>(arguments.integer("--samples", 4, 65536))};
    if (!(options.adc_bailout >= 0 && options.adc_bailout <= 1))
        throw Error("expected --adc-bailout from 0 to 1, found " + arguments.text("--adc-bailout"));
    return options;
}

}  // namespace

ExitCode export_command(const std::vector<std::string>& words) {
    const auto arguments = parse(export_command_line, words);
    const std::filesystem::path output = arguments.text("--output");
    if (output.extension() != ".pov")
        throw Error({output.string()}, "a file that ends in .pov", "'" + output.extension().string() + "'");
    Outputs outputs({.files = {output}, .inputs = arguments.given({"SCENE"})});
    const auto scene = read_scene(arguments.text("SCENE"), memory_limit(arguments));
    outputs.keep(scene.files_read);
    write_file(outputs[output], to_pov(scene, pov_options(arguments)));
    for (const auto& difference : pov_differences(scene)) outputs.say(difference + "\n");
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
