#include "catch.h"
#include "could_not.h"
#include "hostile/refusals.h"

#include "raylab/accelerator/trace_rays.h"
#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/scene/mesh/read_mesh.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <limits>

// Tests of `raylab trace` from outside.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/trace";
const std::string mesh_file = RAYLAB_SOURCE "/tests/scene/meshes/pyramid.off";
const fs::path rays_file = folder / "pyramid.rays", hits_file = folder / "pyramid.hits";

ProcessResult trace(const std::vector<std::string>& words) {
    std::vector<std::string> all{"trace"};
    all.insert(all.end(), words.begin(), words.end());
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", all, {.timeout = 60});
}

ProcessResult trace_pyramid(const std::vector<std::string>& more = {}) {
    fs::remove(hits_file);
    std::vector<std::string> words{mesh_file, "--rays", rays_file.string(), "-o", hits_file.string()};
    words.insert(words.end(), more.begin(), more.end());
    return trace(words);
}

// Rays from above, in rows: most hit one of the four sides.
std::vector<Ray> some_rays() {
    std::vector<Ray> rays;
    for (int i = -12; i <= 12; ++i)
        for (int j = -12; j <= 12; ++j) rays.push_back({{0.1f * float(i), 0.1f * float(j), 3}, {0, 0, -1}});
    return rays;
}

void check_no_hits(const ProcessResult& result, const std::string& fragment) {
    check_could_not(result, fragment);
    CHECK(result.output.empty());
    CHECK_FALSE(fs::exists(hits_file));
}

}  // namespace

TEST_CASE("raylab trace writes the library's hits") {
    const auto rays = some_rays();
    write_file(rays_file, to_bytes(rays));
    const auto result = trace_pyramid();
    INFO(result.errors);
    REQUIRE(result.succeeded());
    const auto mesh = std::make_shared<const Mesh>(read_mesh(mesh_file));
    CHECK(read_file(hits_file) == to_bytes(trace_rays(mesh, rays, {.accelerator = "list"}).hits));
    CHECK_THAT(result.output, Catch::Contains("6 triangles") && Catch::Contains("625 rays"));
}

TEST_CASE("raylab trace --json - tells what was measured, and nothing else") {
    write_file(rays_file, to_bytes(some_rays()));
    const auto result = trace_pyramid({"--json", "-", "--accelerator", "list", "--threads", "2"});
    INFO(result.errors);
    REQUIRE(result.succeeded());
    const auto json = nlohmann::json::parse(result.output);
    CHECK(json.at("accelerator") == "list");
    CHECK(json.at("triangles") == 6);
    CHECK(json.at("rays") == 625);
    CHECK(json.at("threads") == 2);
    for (const auto* key : {"build_seconds", "bytes", "seconds", "rays_per_second"}) {
        INFO(key);
        CHECK(json.at(key).get<double>() >= 0);
    }
    CHECK(json.at("rays_per_second").get<double>() == Approx(625 / json.at("seconds").get<double>()));
}

// A polygon with this many corners, of which a fan has two triangles fewer.
fs::path fan(int corners) {
    std::string vertices, face = std::to_string(corners);
    for (int i = 0; i < corners; ++i) {
        vertices += fmt::format("{} {} 0\n", std::cos(0.1 * i), std::sin(0.1 * i));
        face += fmt::format(" {}", i);
    }
    const auto file = folder / "fan.off";
    write_file(file, fmt::format("OFF\n{} 1 0\n{}{}\n", corners, vertices, face));
    return file;
}

TEST_CASE("raylab trace names the structure that answered: of few triangles a list of boxes, of many a tree") {
    const auto many = some_rays(), few = std::vector(many.begin(), many.begin() + 50);
    struct Asked {
        int triangles;
        const std::vector<Ray>& rays;
        const char* structure;
    };
    // (A fan's triangles fill little of their boxes.)
    for (const auto& [triangles, rays, structure] :
         {Asked{24, many, "boxed_list"}, {25, few, "bvh8"}, {25, many, "bvh8_splits"}}) {
        write_file(rays_file, to_bytes(rays));
        const auto result = trace({fan(triangles + 2).string(), "--rays", rays_file.string(), "-o", hits_file.string(),
                                   "--json", (folder / "fan.json").string()});
        INFO(result.errors);
        REQUIRE(result.succeeded());
        CHECK(nlohmann::json::parse(read_file(folder / "fan.json")).at("accelerator") == structure);
        CHECK_THAT(result.output, Catch::Contains(fmt::format("{} triangles in {}:", triangles, structure)));
    }
}

TEST_CASE("raylab trace --any writes 0 or -1") {
    const auto rays = some_rays();
    write_file(rays_file, to_bytes(rays));
    REQUIRE(trace_pyramid({"--any"}).succeeded());
    const auto mesh = std::make_shared<const Mesh>(read_mesh(mesh_file));
    const auto expected = trace_rays(mesh, rays, {.accelerator = "list", .question = RayQuestion::any});
    CHECK(read_file(hits_file) == to_bytes(expected.hits));
}

TEST_CASE("a former name is answered with the new one") {
    write_file(rays_file, to_bytes(some_rays()));
    check_no_hits(trace_pyramid({"--accelerator", "wide"}), "wide is called bvh8");
    check_no_hits(trace_pyramid({"--accelerator=aabb_splits:3"}), "aabb_splits is called bvh_splits");
    const auto tree = run_process(fs::path(RAYLAB_BUILD) / "raylab", {"tree", "x.toml", "--feelers"}, {.timeout = 60});
    CHECK(tree.code == 2);
    CHECK_THAT(tree.errors, Catch::Contains("--feelers is called --shadow-rays"));
}

TEST_CASE("raylab trace refuses a bad ray by its number and writes nothing") {
    auto rays = some_rays();
    write_file(rays_file, to_bytes(rays) + "x");
    check_no_hits(trace_pyramid(), "pyramid.rays ray 625: expected 32 bytes, found 1");
    rays[17].direction = {0, 0, 0};
    write_file(rays_file, to_bytes(rays));
    check_no_hits(trace_pyramid(), "pyramid.rays ray 17: expected a direction that is not zero");
}

TEST_CASE("raylab trace refuses what it cannot use: a mesh, rays, an accelerator, a number of threads, no output") {
    write_file(rays_file, to_bytes(some_rays()));
    const auto rays = rays_file.string(), hits = hits_file.string();
    check_no_hits(trace({"no_such.off", "--rays", rays, "-o", hits}),
                  "no_such.off: expected a file, found nothing there");
    check_no_hits(trace({mesh_file, "--rays", "no_such.rays", "-o", hits}), "no_such.rays: expected a file");
    check_no_hits(trace_pyramid({"--accelerator", "wishful"}), "wishful");
    check_no_hits(trace_pyramid({"--threads", "1025"}), "expected --threads from 0 to 1024, found 1025");
    check_no_hits(trace({mesh_file, "--rays", rays}), "expected --output, found nothing");
    check_no_hits(trace({mesh_file, "-o", hits}), "expected --rays, found nothing");
    check_no_hits(trace_pyramid({"--no-such-option"}), "--no-such-option");
}

TEST_CASE("raylab trace refuses every broken mesh with exit code 2 and one line, and writes nothing") {
    write_file(rays_file, to_bytes(some_rays()));
    for (const auto& [mesh, fragment] : refusals(RAYLAB_SOURCE "/tests/hostile/meshes")) {
        INFO(mesh);
        fs::remove(hits_file);
        check_no_hits(trace({mesh.string(), "--rays", rays_file.string(), "-o", hits_file.string()}), fragment);
    }
}
