#include "catch.h"
#include "could_not.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <filesystem>

// Tests of the option --memory of the commands.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

const fs::path folder = fs::path(RAYLAB_BUILD) / "tests" / "memory";

ProcessResult raylab_with(const std::vector<std::string>& words) {
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
}

// 8192 instances of a mesh of 2048 triangles: 200 KB that need an accelerator of 1.8 GiB.
std::string instances() {
    constexpr int side = 32;
    std::string off =
        "OFF\n" + std::to_string((side + 1) * (side + 1)) + " " + std::to_string(2 * side * side) + " 0\n";
    for (int i = 0; i <= side; ++i)
        for (int j = 0; j <= side; ++j) off += std::to_string(i) + " " + std::to_string(j) + " 0\n";
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const int a = i * (side + 1) + j;
            for (const auto& [p, q, r] : {std::array{a, a + 1, a + side + 1}, {a + 1, a + side + 2, a + side + 1}})
                off += "3 " + std::to_string(p) + " " + std::to_string(q) + " " + std::to_string(r) + "\n";
        }
    write_file(folder / "grid.off", off);
    std::string scene =
        "raylab = 1\n[image]\nwidth = 8\nheight = 8\n[group.a]\nshapes = [{ type = \"mesh\", file = \"grid.off\" }]\n";
    for (int i = 0; i < 8192; ++i) scene += "[[instance]]\nof = \"a\"\n";
    write_file(folder / "instances.toml", scene);
    return folder / "instances.toml";
}

void check_refused(const std::vector<std::string>& words, const std::string& need) {
    INFO(words[0]);
    check_could_not(raylab_with(words), "expected at most 1.0 GiB (--memory), found " + need);
}

}  // namespace

TEST_CASE("instances and pictures that need more than --memory are refused before it is taken") {
    const std::string scene = instances(), picture = folder / "x.png", tree = folder / "x.json";
    const std::string need = "a scene that needs 1.8 GiB: 16777216 triangles and other primitives in 8192 objects";
    check_refused({"render", scene, "-o", picture, "--memory", "1G"}, need + ", and 8 x 8 pixels");
    check_refused({"tree", scene, "--pixel", "4,4", "-o", tree, "--memory", "1G"}, need);
    const std::string sphere = folder / "sphere.toml";
    write_file(sphere, "raylab = 1\n[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\n");
    check_refused(
        {"render", sphere, "--size", "16384x16384", "-o", picture, "--memory", "1G"},
        "a scene that needs 6.0 GiB: 1 triangles and other primitives in 1 objects, and 16384 x 16384 pixels");
    CHECK(raylab_with({"render", sphere, "--size", "16x16", "-o", picture, "--memory", "64M"}).code == 0);
}

TEST_CASE("what builds no accelerator is not refused for one") {
    const std::string scene = instances();
    CHECK(raylab_with({"needs", scene, "--memory", "64M"}).code == 0);
    CHECK(raylab_with({"export", scene, "-o", folder / "x.pov", "--memory", "64M"}).code == 0);
    CHECK(raylab_with({"needs", scene, "--memory", "lots"}).code == 2);
}

TEST_CASE("a curved surface of more than a million pieces is refused before they are made") {
    const std::string scene = folder / "spheres.toml";
    write_file(scene, "raylab = 1\n[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\n"
                      "[[shape]]\ntype = \"paraboloid\"\nbase = [0, 0, 3]\ntop = [0, 0, 4]\nradius = 1\n");
    for (const std::string pair : {"--from 'sphere 0' --to 'paraboloid 1'", "--from 'paraboloid 1' --to 'sphere 0'"}) {
        const auto result = run_process("/bin/sh",
                                        {"-c", "ulimit -v 4000000; exec " RAYLAB_BUILD "/raylab form-factor " + scene +
                                                   " " + pair + " --edge 1e-4"},
                                        {.timeout = 60});
        CHECK(result.code == 2);
        CHECK(result.errors.find("expected at most a million flat pieces in all, found more: a larger --edge") !=
              result.errors.npos);
    }
}
