#include "render/program.h"

#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/image/picture_files/sampled_files.h"

#include <algorithm>

namespace raylab::test {

namespace fs = std::filesystem;

fs::path written(const std::string& name) {
    const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/render";
    fs::create_directories(folder);
    return folder / name;
}

std::string spread_scene() {
    const fs::path file = written("spread.toml");
    write_file(file, R"(raylab = 1
[image]
width = 24
height = 16
[camera]
position = [0, 1, 4]
target = [0, 0.5, 0]
lens = { radius = 0.1, focus = 4 }
[background]
color = [0.2, 0.3, 0.4]
[material.floor]
diffuse = [0.5, 0.4, 0.3]
kr = 0.3
gloss = 50
[material.light]
diffuse = [0, 0, 0]
emission = [5, 5, 5]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[shape]]
type = "sphere"
center = [0.5, 2, 0]
radius = 0.3
material = "light"
[[shape]]
type = "sphere"
center = [0, 0.5, 0]
radius = 0.5
)");
    return file.string();
}

ProcessResult ran(const std::vector<std::string>& words) {
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 120});
}

fs::path drawn(const std::string& name, std::vector<std::string> options) {
    const fs::path file = written(name);
    if (std::ranges::find(options, "--resume") == options.end()) fs::remove(file);
    options.insert(options.begin(), {"render", spread_scene(), "-o", file.string()});
    const ProcessResult result = ran(options);
    INFO(result.errors);
    REQUIRE(result.succeeded());
    return file;
}

bool same_bits(const fs::path& a, const fs::path& b) {
    const SampledImage one = read_sampled(a).image, other = read_sampled(b).image;
    if (one.width() != other.width() || one.height() != other.height()) return false;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x) {
            const PixelSums &p = one.at(x, y), &q = other.at(x, y);
            if (p.color != q.color || p.squared_luminance != q.squared_luminance || p.count != q.count) return false;
        }
    return true;
}

}  // namespace raylab::test
