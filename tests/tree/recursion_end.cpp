#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/image/picture_files/files.h"

#include <nlohmann/json.hpp>

#include <filesystem>

// Where the recursion ends when the command line does not say so: at the depth and the throughput of `raylab needs`.

namespace fs = std::filesystem;
using raylab::ProcessResult;

namespace {

const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/tree";

// A white background, seen through two clear balls of glass, seen in a mirror: the eye ray, the mirrored one, and two
// for each ball. Depth 5 ends inside the second.
constexpr const char* ball_in_mirror = R"(raylab = 1
[image]
width = 9
height = 9
[camera]
type = "orthographic"
position = [0, 0, 5]
target = [0, 0, 0]
up = [0, 1, 0]
height = 0.1
[background]
color = [1, 1, 1]
[material.mirror]
diffuse = [0, 0, 0]
kr = 1
[material.glass]
diffuse = [0, 0, 0]
kt = 1
ior = 1.5
[[shape]]
type = "disk"
center = [0, 0, 0]
normal = [1, 0, 1]
radius = 1
material = "mirror"
[[shape]]
type = "sphere"
center = [3, 0, 0]
radius = 1
material = "glass"
[[shape]]
type = "sphere"
center = [6, 0, 0]
radius = 1
material = "glass"
)";

ProcessResult lab(const std::vector<std::string>& words) {
    return raylab::run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
}

std::string scene() {
    const auto file = folder / "ball_in_mirror.toml";
    raylab::write_file(file, ball_in_mirror);
    return file.string();
}

ProcessResult rendered(const std::vector<std::string>& more) {
    std::vector<std::string> words{"render", scene(), "-o", (folder / "ball_in_mirror.exr").string()};
    words.insert(words.end(), more.begin(), more.end());
    return lab(words);
}

raylab::Pixel middle() { return raylab::read_image(folder / "ball_in_mirror.exr").at(4, 4); }

std::size_t nodes(const std::vector<std::string>& more) {
    std::vector<std::string> words{"tree", scene(), "--pixel", "4,4", "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    return nlohmann::json::parse(lab(words).output)["nodes"].size();
}

}  // namespace

TEST_CASE("without --depth, what is seen through glass in a mirror is not black; with --depth 5 it is") {
    auto result = rendered({});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    CHECK(middle().g == 1);
    CHECK_THAT(result.output, Catch::Contains("rays are followed to depth 32 while their throughput is above 0.0039"));
    result = rendered({"--depth", "5"});
    CHECK(middle().g == 0);
    CHECK_THAT(result.output, Catch::Contains("rays are followed to depth 5\n"));
    CHECK_THAT(result.output, Catch::Contains("/ball_in_mirror.exr: 9 x 9 pixels, 1 ray each, "));
    CHECK(nodes({}) == 6);
    CHECK(nodes({"--depth", "3"}) == 4);
}

TEST_CASE("a threshold that is named ends rays, at depth 32 at the latest") {
    CHECK(rendered({"--threshold", "0.5"}).output.find("above 0.5\n") != std::string::npos);
    const auto json = nlohmann::json::parse(lab({"render", scene(), "--threshold", "0", "--json", "-"}).output);
    CHECK(json["depth"] == 32);
    CHECK(json["threshold"] == 0);
}
