#include "catch.h"
#include "hostile/refusals.h"

#include "raylab/base/process.h"

#include <algorithm>
#include <filesystem>

// Tests of a chapter from outside with scenes that must be refused.

using namespace raylab;
namespace fs = std::filesystem;

TEST_CASE("every broken scene ends a chapter with exit 2 and one line, and no file is written") {
    const fs::path program = fs::path(RAYLAB_BUILD) / "chapters/04_transforms/04_transforms";
    const fs::path out = fs::path(RAYLAB_BUILD) / "tests/broken_scenes";
    fs::remove_all(out);
    const auto scenes = refusals(RAYLAB_SOURCE "/tests/hostile/scenes");
    CHECK(scenes.size() >= 60);
    for (const auto& [scene, fragment] : scenes) {
        const auto result = run_process(program, {"--scene", scene.string(), "--only", "story", "--out", out.string()},
                                        {.timeout = 30});
        INFO(scene << "\n" << to_string(result) << "\n" << result.errors);
        CHECK((result.end == ProcessResult::End::exited && result.code == 2));
        CHECK(std::ranges::count(result.errors, '\n') == 1);
        CHECK(result.errors.find(fragment) != std::string::npos);
    }
    std::size_t written = 0;
    if (fs::exists(out))
        for (const auto& entry : fs::recursive_directory_iterator(out)) written += entry.is_regular_file();
    CHECK(written == 0);
}
