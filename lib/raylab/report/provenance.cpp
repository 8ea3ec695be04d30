#include "raylab/report/provenance.h"

#include "raylab/base/process.h"
#include "raylab/base/thread_pool.h"

#include <sys/auxv.h>
#include <sys/utsname.h>

#include <chrono>
#include <ctime>
#include <fstream>

// CMake defines RAYLAB_SOURCE, RAYLAB_BUILD, RAYLAB_VERSION and RAYLAB_FLAGS, the last two for this file alone.

namespace raylab {

namespace {

std::string trimmed(const std::string& text) {
    const auto begin = text.find_first_not_of(" \t\n");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t\n") - begin + 1);
}

std::string system_name() {
    std::ifstream file("/etc/os-release");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("PRETTY_NAME=\"")) return line.substr(13, line.size() - 14);
    utsname names{};
    return uname(&names) == 0 ? names.sysname : "unknown";
}

std::string compiler_name() {
#if defined(__clang__)
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string today() {
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
    return text;
}

// The commit; empty without git, or where the sources are not in a repository.
std::string commit() {
    if (find_program("git").empty()) return "";
    const auto result = run_process(
        "git", {"-C", RAYLAB_SOURCE, "describe", "--always", "--dirty=, with changes", "--exclude=*"}, {.timeout = 5});
    return result.succeeded() ? trimmed(result.output) : "";
}

// The handout that this program belongs to, as HANDOUT/build/release/raylab; empty where it belongs to none.
const std::filesystem::path& handout() {
    static const std::filesystem::path found = [] {
        const auto* const started_as = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
        std::error_code none;
        const auto program = std::filesystem::canonical(started_as ? started_as : "", none);
        const auto folder = program.parent_path().parent_path().parent_path();
        return std::filesystem::exists(folder / "handout.txt", none) ? folder : std::filesystem::path();
    }();
    return found;
}

}  // namespace

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return trimmed(line.substr(line.find(':') + 1));
    utsname names{};
    return uname(&names) == 0 ? names.machine : "unknown";
}

std::vector<Fact> machine_facts() {
    std::vector<Fact> facts = {{"processor", processor_name()},
                               {"cores", std::to_string(core_count())},
                               {"system", system_name()},
                               {"compiler", compiler_name() + ", " RAYLAB_FLAGS},
                               {"raylab", RAYLAB_VERSION}};
    if (const auto name = commit(); !name.empty()) facts.push_back({"commit", name});
    facts.push_back({"date", today()});
    return facts;
}

std::filesystem::path source_folder() { return handout().empty() ? RAYLAB_SOURCE : handout(); }

std::filesystem::path build_folder() { return handout().empty() ? RAYLAB_BUILD : handout() / "build/release"; }

}  // namespace raylab
