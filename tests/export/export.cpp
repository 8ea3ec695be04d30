#include "catch.h"
#include "could_not.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/scene/pov/write_pov.h"
#include "raylab/scene/read_scene.h"

// Tests of `raylab export` from outside.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const fs::path output = fs::path(RAYLAB_BUILD) / "tests/export/scene.pov";
const std::string scene_file = RAYLAB_SOURCE "/tests/scene/files/every_key.toml";

ProcessResult exported(const std::vector<std::string>& more, const fs::path& to = output) {
    fs::remove(to);
    std::vector<std::string> words{"export", scene_file, "-o", to.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
}

void check_none(const fs::path& to, const ProcessResult& result, const std::string& fragment) {
    check_could_not(result, fragment);
    CHECK_FALSE(fs::exists(to));
}

}  // namespace

TEST_CASE("raylab export writes the library's text and says what POV-Ray will show otherwise") {
    const auto result = exported({"--depth", "3", "--adc-bailout", "0.01"});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    const auto scene = read_scene(scene_file);
    CHECK(read_file(output) == to_pov(scene, {.depth = 3, .adc_bailout = 0.01}));
    for (const auto& difference : pov_differences(scene)) CHECK_THAT(result.output, Catch::Contains(difference));
}

TEST_CASE("raylab export refuses other formats and options out of range, and writes nothing") {
    const auto blend = fs::path(output).replace_extension(".blend"), bare = fs::path(output).replace_extension();
    check_none(blend, exported({}, blend), "scene.blend: expected a file that ends in .pov, found '.blend'");
    check_none(bare, exported({}, bare), "expected a file that ends in .pov, found ''");
    check_none(output, exported({"--depth", "0"}), "expected --depth from 1 to 256, found 0");
    check_none(output, exported({"--adc-bailout", "2"}), "expected --adc-bailout from 0 to 1, found 2");
}

TEST_CASE("raylab export ends the recursion where raylab render does") {
    REQUIRE(exported({}).succeeded());
    CHECK(read_file(output) == to_pov(read_scene(scene_file), {.depth = 32, .adc_bailout = 1.0 / 256}));
    REQUIRE(exported({"--depth", "4"}).succeeded());
    CHECK(read_file(output) == to_pov(read_scene(scene_file), {.depth = 4}));
}
