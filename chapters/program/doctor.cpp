#include "commands.h"

#include "level.h"

#include "raylab/base/command_line.h"
#include "raylab/base/print.h"
#include "raylab/base/process.h"
#include "raylab/base/thread_pool.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <string>

namespace raylab {

namespace fs = std::filesystem;

namespace {

const CommandLine doctor_command_line{
    .program = "raylab doctor",
    .about = "Shows what this machine has for the lab, and what is missing. Exit code 1: something is missing."};

enum class Need { required, optional };

// A line of the report; its sign is always accompanied by words.
struct Finding {
    std::string what, found, without;  // `without` says what does not work where nothing was found
    Need need = Need::optional;

    bool missing() const { return found.empty(); }
};

// The first line of a program's output that is not a message of its own ("povray: cannot open ...").
std::string version_in(const std::string& text, const std::string& program) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && !line.starts_with(program + ": ")) return line;
    return {};
}

// A program of the PATH and the version that it prints.
Finding program(const std::string& name, const std::string& option, const std::string& without, Need need) {
    Finding finding{name, "", without, need};
    const auto path = find_program(name);
    if (path.empty()) return finding;
    const auto asked = run_process(path, {option}, {.timeout = 10});
    if (!asked.succeeded()) {
        finding.without = failure_of(path.string(), asked);
        return finding;
    }
    finding.found = version_in(asked.output + "\n" + asked.errors, name);
    if (finding.found.empty()) finding.found = path.string();
    return finding;
}

Finding real_meshes() {
    const fs::path folder = fs::path(RAYLAB_SOURCE) / "build/meshes";
    std::error_code unreadable;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder, unreadable)) count += entry.is_regular_file();
    return {"real meshes", count > 0 ? fmt::format("{} files in build/meshes", count) : "",
            "chapters use generated meshes; ./raylab tour fetches the real ones"};
}

std::vector<Finding> findings() {
    return {{"cores", std::to_string(core_count()), ""},
            program("c++", "--version", "nothing can be built", Need::required),
            program("cmake", "--version", "nothing can be built", Need::required),
            program("ninja", "--version", "nothing can be built", Need::required),
            program("nm", "--version", "`check` cannot read an answer's object file", Need::required),
            {"isolation", to_string(grading::best_isolation()), ""},  // of students' programs, in `check`
            program("gnuplot", "--version", "charts are written as data only", Need::required),
            program("ccache", "--version", "builds take longer after a change of branch", Need::optional),
            program("clang++-16", "--version", "`test` cannot run the fuzzers", Need::optional),
            program("povray", "--version", "the tests skip the comparison with POV-Ray", Need::optional),
            {"Embree", RAYLAB_EMBREE, "`bench` has nothing to compare speed with (Debian: libembree-dev)"},
            real_meshes()};
}

}  // namespace

ExitCode doctor_command(const std::vector<std::string>& words) {
    parse(doctor_command_line, words);
    auto verdict = ExitCode::as_it_should_be;
    for (const auto& finding : findings()) {
        const bool ill = finding.missing() && finding.need == Need::required;
        const char* sign = ill ? "✗ missing" : finding.missing() ? "- absent " : "✓ found  ";
        print_text(
            fmt::format("  {}  {:<12}  {}\n", sign, finding.what, finding.missing() ? finding.without : finding.found));
        if (ill) verdict = ExitCode::negative;
    }
    return verdict;
}

}  // namespace raylab
