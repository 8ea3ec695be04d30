#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <filesystem>

// Tests the schema as an editor uses it: by an independent validator (Debian's python3-jsonschema).

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const fs::path source = RAYLAB_SOURCE;

// The messages of the scenes that the schema refuses, one on each line.
std::string refused(const std::vector<std::string>& scenes) {
    std::vector<std::string> words{(source / "tests/scene/validate.py").string(),
                                   (source / "lib/raylab/scene/scene.schema.json").string()};
    words.insert(words.end(), scenes.begin(), scenes.end());
    const auto result = run_process("python3", words, {.timeout = 60});
    INFO(to_string(result) << "\n" << result.errors);
    REQUIRE(result.succeeded());
    return result.output;
}

}  // namespace

TEST_CASE("a validator that is not ours accepts every chapter's scene by the schema") {
    std::vector<std::string> scenes{(source / "tests/scene/files/every_key.toml").string()};
    for (const auto& entry : fs::recursive_directory_iterator(source / "chapters"))
        if (entry.path().extension() == ".toml") scenes.push_back(entry.path().string());
    REQUIRE(scenes.size() > 4);
    CHECK(refused(scenes) == "");
}

TEST_CASE("a validator that is not ours refuses by the schema what is no scene") {
    const fs::path file = fs::path(RAYLAB_BUILD) / "tests/scene/no_scene.toml";
    write_file(file, "[camera]\nposition = [0, 1]\nunheard_of = true\n");
    const auto lines = refused({file.string()});
    INFO(lines);
    CHECK(lines.find("$.camera") != lines.npos);
    CHECK(lines.find("unheard_of") != lines.npos);
}
