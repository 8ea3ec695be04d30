#include "bench/options.h"
#include "commands.h"

#include "raylab/base/error.h"
#include "raylab/base/process.h"

#include <filesystem>

namespace raylab {

namespace {

/// The program that knows the peers, built if it is not there or older than its sources.
std::filesystem::path bench_program() {
    const std::filesystem::path build = RAYLAB_BUILD;
    const auto built = run_process(find_program("ninja"), {"-C", build.string(), "--quiet", "raylab_bench"});
    if (!built.succeeded())
        throw Error("building raylab_bench: " + to_string(built) + "\n" + built.output + built.errors);
    return build / "raylab_bench";
}

}  // namespace

ExitCode bench_command(const std::vector<std::string>& words) {
    parse(bench::command_line(), words);  // for --help, and to refuse bad words before anything is built
    constexpr auto passed_on = ProcessOptions::Stream::passed_on;
    const auto result = run_process(bench_program(), words, {.output = passed_on, .errors = passed_on});
    if (result.end != ProcessResult::End::exited) throw Error("raylab_bench: " + to_string(result));
    return static_cast<ExitCode>(result.code);
}

}  // namespace raylab
