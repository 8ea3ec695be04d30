#include "catch.h"

#include "raylab/base/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

// Checks the compiler's flags for every file, including the students' answers and each program's own files.

namespace fs = std::filesystem;

namespace {

// Files that make no geometric decisions: a program that shows the effect of contraction, and files that call CGAL.
bool is_exempt(const fs::path& file) {
    return file.filename() == "fma_shots.cpp" || file.filename() == "cgal_peer.cpp" ||
           file.stem().string().ends_with("_cgal");
}

std::vector<std::string> words(const std::string& command) {
    std::istringstream stream(command);
    return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> flags_needed() {
#if defined(__clang__)
    return {"-ffp-contract=off"};
#else
    return {"-ffp-contract=off", "-fno-tree-slp-vectorize"};
#endif
}

// Whether a flag revokes a required one, or the rules of IEEE 754.
bool is_refused(const std::string& flag) {
    constexpr std::array refused{"-Ofast", "-ffast-math", "-funsafe-math-optimizations", "-fassociative-math",
                                 "-ftree-slp-vectorize"};
    return std::ranges::find(refused, flag) != refused.end() ||
           (flag.starts_with("-ffp-contract=") && flag != "-ffp-contract=off");
}

}  // namespace

TEST_CASE("every file is compiled with the flags that exact decisions need") {
    const auto commands = nlohmann::json::parse(raylab::read_file(RAYLAB_BUILD "/compile_commands.json"));
    std::size_t checked = 0;
    for (const auto& entry : commands) {
        const fs::path file = entry.at("file").get<std::string>();
        if (is_exempt(file)) continue;
        const auto flags = words(entry.at("command").get<std::string>());
        const auto has = [&](const std::string& flag) { return std::ranges::find(flags, flag) != flags.end(); };
        INFO(file);
        if (!std::ranges::all_of(flags_needed(), has)) FAIL_CHECK("a flag is missing");
        if (std::ranges::any_of(flags, is_refused)) FAIL_CHECK("a flag is refused");
        ++checked;
    }
    CHECK(checked > 300);
}
