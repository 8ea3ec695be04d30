#include "raylab/accelerator/accelerator.h"
#include "raylab/base/command_line.h"
#include "raylab/base/memory_limit.h"
#include "raylab/tracer/shading/ray_start.h"

#include "fuzz/value_or_error.h"

#include <cassert>
#include <cmath>
#include <sstream>

using namespace raylab;

namespace {

// The command line has one option of each kind that the lab's commands have.
const CommandLine command_line{.program = "fuzz",
                               .about = "",
                               .positionals = {{"SCENE", "one"}, {"CASE", "more", Positional::Count::any}},
                               .options = {{"-o,--output", "FILE", "a name"},
                                           {"--any", "", "a switch"},
                                           {"--threads", "N", "a whole number", "1"},
                                           {"--threshold", "SHARE", "a number", "0"},
                                           {"--memory", "LIMIT", "bytes", "1G"},
                                           {"--size", "WIDTHxHEIGHT", "two whole numbers", "1x1"},
                                           {"--offset", "HOW", "how rays leave a surface", "none"},
                                           {"--structure", "NAME", "of accelerators", "auto", Option::Repeat::all}}};

std::vector<std::string> lines(std::string_view bytes) {
    std::vector<std::string> found;
    std::istringstream text{std::string(bytes)};
    for (std::string line; std::getline(text, line);) found.push_back(line);
    return found;
}

}  // namespace

// Any words, one on each line, must give options with values in their ranges, a request for help or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Scene scene{.objects = {{.shape = Sphere{.center = {0, 0, 0}, .radius = 1}}}};
    return value_or_error(data, size, [](std::string_view bytes) {
        try {
            const Arguments arguments = parse(command_line, lines(bytes));
            const auto threads = arguments.integer("--threads", 1, 1024);
            assert(threads >= 1 && threads <= 1024);
            assert(std::isfinite(arguments.number("--threshold")));
            assert(memory_limit_from_words(arguments.text("--memory")).bytes > 0);
            if (const auto size = two_integers(arguments.text("--size"), 'x'))
                assert((*size)[0] >= 0 && (*size)[1] >= 0);
            assert(ray_start_from_words(arguments.text("--offset")).amount >= 0);
            for (const auto& name : arguments.all("--structure")) assert(make_accelerator(name, scene));
        } catch (const HelpWanted& help) {
            assert(!help.text.empty());
        }
    });
}
