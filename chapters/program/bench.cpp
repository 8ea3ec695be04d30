#include "bench/options.h"
#include "bench/race_options.h"
#include "chapter_programs.h"
#include "commands.h"

#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/report/build_target.h"
#include "raylab/report/provenance.h"

#include <filesystem>

namespace raylab {

namespace {

/// The path of the program that contains the peers; it is built if it does not exist or is older than its sources.
std::filesystem::path bench_program() {
    constexpr double ten_minutes = 600;  // on a slow machine CGAL's headers alone take a minute
    const auto built = build_target("raylab_bench", ten_minutes);
    if (!built.succeeded()) throw Error(failure_of("building raylab_bench", built));
    return build_folder() / "raylab_bench";
}

}  // namespace

ExitCode bench_command(const std::vector<std::string>& words) {
    // Wrong words and outputs are refused before anything is built.
    const auto arguments = parse(bench::command_line(), words);
    bench::race_options(arguments, {});
    { const Outputs checked({.files = arguments.given({"--json"}), .folders = arguments.given({"--out"})}); }
    const auto result = run_for_us(bench_program(), words, {.output = ProcessOptions::Stream::passed_on});
    return static_cast<ExitCode>(result.code);
}

}  // namespace raylab
