#include "catch.h"
#include "rotating.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <filesystem>
#include <future>
#include <set>
#include <string>
#include <vector>

// Tests that checks which run at the same time know nothing of each other, and leave nothing behind.

namespace fs = std::filesystem;
using raylab::ProcessResult;

namespace {

const fs::path at_once = fs::path(RAYLAB_BUILD) / "tests/at_once";

ProcessResult check_of_spheres(const fs::path& answer, const fs::path& scratch) {
    const std::vector<std::string> words{"TMPDIR=" + scratch.string(),
                                         RAYLAB_BUILD "/raylab",
                                         "check",
                                         "02",
                                         "--verdict-only",
                                         "--answer",
                                         answer.string()};
    return raylab::run_process("env", words, {.folder = RAYLAB_SOURCE, .timeout = 240});
}

fs::path known_answer(const std::string& name) {
    return fs::path(RAYLAB_SOURCE) / "exercises/02_ray_sphere" / (name + ".cpp");
}

std::set<fs::path> files_below(const fs::path& folder) {
    std::set<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) found.insert(entry.path());
    return found;
}

}  // namespace

TEST_CASE("of pairs of a right and a wrong answer, all checked at once, each has its own verdict") {
    const int pairs = all_are_tested() ? 12 : 4;
    fs::remove_all(at_once);
    fs::create_directories(at_once);
    const auto before = files_below(fs::path(RAYLAB_BUILD) / "exercises");
    std::vector<std::future<ProcessResult>> right, wrong;
    for (int i = 0; i < pairs; ++i) {
        right.push_back(std::async(std::launch::async, check_of_spheres, known_answer("right/geometric"), at_once));
        wrong.push_back(std::async(std::launch::async, check_of_spheres, known_answer("mistakes/far_root"), at_once));
    }
    for (int i = 0; i < pairs; ++i) {
        const auto passed = right[static_cast<std::size_t>(i)].get(), failed = wrong[static_cast<std::size_t>(i)].get();
        INFO(passed.output << passed.errors << failed.output << failed.errors);
        CHECK(passed.code == 0);
        CHECK(failed.code == 1);
        CHECK(failed.output.find("The first wrong answer") != std::string::npos);
    }
    CHECK(fs::is_empty(at_once));
    CHECK(files_below(fs::path(RAYLAB_BUILD) / "exercises") == before);
}
