#include "same_bits.h"
#include "without.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/print.h"
#include "raylab/base/program.h"

// Measures the cost of a feature of the renderer for a scene that does not need it: see measure.

namespace {

using namespace raylab;

const CommandLine command_line{
    .program = "bench_needs",
    .about = "A picture that does not need a feature, by the renderer and by one compiled without that feature.",
    .options = {{"--feature", "NAME", "which; without it their names are printed"},
                {"--by", "WHOM", "renderer, without, or both: then the bits are compared", "both"}}};

template <class Needless>
ExitCode draw(const Needless& picture, const std::string& by) {
    if (by == "renderer") drawn_by_renderer(picture);
    if (by == "without") drawn_without(picture);
    if (by != "both") return ExitCode::as_it_should_be;
    return same_bits(drawn_by_renderer(picture), drawn_without(picture)) ? ExitCode::as_it_should_be
                                                                         : ExitCode::negative;
}

ExitCode run(const Arguments& arguments) {
    const auto feature = arguments.text_if_given("--feature");
    std::optional<ExitCode> drawn;
    const auto draw_if_wanted = [&](const auto& pictures) {
        for (const auto& picture : pictures) {
            if (!feature) print_text(picture.feature + "\n");
            if (feature == picture.feature) drawn = draw(picture, arguments.text("--by"));
        }
    };
    draw_if_wanted(needless_pictures());
    draw_if_wanted(needless_spreads());
    if (drawn) return *drawn;
    if (!feature) return ExitCode::as_it_should_be;
    throw Error("expected --feature and one of the names that bench_needs prints, found \"" + *feature + "\"");
}

}  // namespace

int main(int argc, char** argv) {
    return run_program([&] { return run(parse(command_line, words(argc, argv))); });
}
