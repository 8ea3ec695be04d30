#include "catch.h"

#include "raylab/base/process.h"

#include <filesystem>

// Tests of `raylab watch`.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

ProcessResult watch(const std::vector<std::string>& words, const std::string& keys = "") {
    std::vector<std::string> all{"watch"};
    all.insert(all.end(), words.begin(), words.end());
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", all, {.input = keys, .folder = RAYLAB_SOURCE, .timeout = 60});
}

bool says(const ProcessResult& result, const std::string& words) {
    return result.output.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a watch checks what is there, shows the progress, the file and why it is not done") {
    const auto result = watch({"02", "--once"});
    INFO(result.output << result.errors);
    CHECK(result.code == 1);
    CHECK(says(result, "0 of "));
    CHECK(says(result, "exercises/02_ray_sphere/nearest_sphere_hit.cpp:1"));
    CHECK(says(result, "not written yet"));
}

TEST_CASE("a watch gives hints on request, goes on to the next exercise, and ends where it is told to") {
    const auto result = watch({"02"}, "hnq");
    INFO(result.output << result.errors);
    CHECK(result.code == 0);
    CHECK(says(result, "Hint 1 of 3"));
}
