#include "catch.h"
#include "rooms.h"

#include "raylab/base/file.h"
#include "raylab/base/temporary.h"
#include "raylab/radiosity/adaptive_radiosity.h"

#include <filesystem>
#include <vector>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

Scene lit_room() {
    Scene scene = cube_room(0.5);
    scene.materials[1].emission = Color(1);
    return scene;
}

SceneRadiosity solved_with(RadiosityCache& cache, const Scene& scene) {
    return scene_radiosity(scene, {.edge = 0.5, .solver = "shooting", .solving = {.residual = 1e-6}, .cache = &cache});
}

/// What a second run reuses after a change of the scene that the first one solved.
SceneRadiosity::Reused reused_after(const std::function<void(Scene&)>& change) {
    const ScratchFolder folder;
    RadiosityCache cache(folder.path());
    Scene scene = lit_room();
    const auto first = solved_with(cache, scene).reused;
    CHECK_FALSE((first.form_factors || first.solution));
    change(scene);
    const auto again = solved_with(cache, scene);
    CHECK(
        again.solution.radiosity ==
        scene_radiosity(scene, {.edge = 0.5, .solver = "shooting", .solving = {.residual = 1e-6}}).solution.radiosity);
    CHECK(cache.sentences().empty());
    return again.reused;
}

fs::path file_of(const fs::path& folder, const std::string& step) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(step)) return entry.path();
    FAIL("no file of the step " + step);
    return {};
}

}  // namespace

TEST_CASE("geometry makes form factors, light and reflectance the solution, the camera neither") {
    struct Row {
        std::string change;
        std::function<void(Scene&)> make;
        bool form_factors, solution;
    };
    const std::vector<Row> rows{
        {"nothing", [](Scene&) {}, true, true},
        {"camera",
         [](Scene& scene) {
             scene.camera.position = {0.5, 0.5, 0.1};
         },
         true, true},
        {"emission", [](Scene& scene) { scene.materials[1].emission = Color(2, 1, 1); }, true, false},
        {"reflectance", [](Scene& scene) { scene.materials[3].diffuse = Color(0.5, 0.6, 0.5); }, true, false},
        {"a light",
         [](Scene& scene) {
             scene.lights = {{.kind = PointLight{{0.5, 0.5, 0.5}}, .color = Color(1)}};
         },
         true, false},
        {"a wall moved",
         [](Scene& scene) {
             scene.objects[5].shape = float_rectangle({0, 0, 1.25f}, {0, 1, 0}, {1, 0, 0});
         },
         false, false},
        {"a side shown", [](Scene& scene) { scene.objects[5].sides = Sides::both; }, false, false},
        {"a box without light", [](Scene& scene) { add_box_without_bottom(scene); }, false, false}};
    for (const Row& row : rows) {
        INFO(row.change);
        const auto reused = reused_after(row.make);
        CHECK(reused.form_factors == row.form_factors);
        CHECK(reused.solution == row.solution);
    }
}

TEST_CASE("another way to form factors, or to the solution, is another step") {
    const ScratchFolder folder;
    RadiosityCache cache(folder.path());
    const Scene scene = lit_room();
    const auto reused = [&](SceneRadiosityOptions options) {
        options.edge = 0.5;
        options.cache = &cache;
        return scene_radiosity(scene, options).reused;
    };
    const SceneRadiosityOptions first;
    reused(first);
    SceneRadiosityOptions rays = first, method = first, rows = first, solver = first, residual = first, threads = first;
    rays.form_factors.rays = 4;
    method.form_factors.method = "polygon";
    rows.rows = SceneRadiosityOptions::Rows::raw;
    solver.solver = "jacobi";
    residual.solving.residual = 1e-4;
    threads.form_factors.threads = 3;
    for (const auto& other : {rays, method, rows}) CHECK_FALSE(reused(other).form_factors);
    for (const auto& other : {solver, residual}) {
        const auto [form_factors, solution] = reused(other);
        CHECK((form_factors && !solution));
    }
    CHECK(reused(threads).solution);  // the bits do not depend on it
}

TEST_CASE("every round of a mesh that adapts is kept, and found again") {
    const ScratchFolder folder;
    RadiosityCache cache(folder.path());
    const SceneRadiosityOptions options{.edge = 0.0625, .cache = &cache};
    const auto first = adaptive_radiosity(lit_room(), options, 0.2),
               again = adaptive_radiosity(lit_room(), options, 0.2);
    CHECK(first.mesh->hanging.size() > 0);
    CHECK(again.reused.form_factors);
    CHECK(again.reused.solution);
    CHECK(again.solution.radiosity == first.solution.radiosity);
}

TEST_CASE("all that is told of a solution comes back with it") {
    const ScratchFolder folder;
    RadiosityCache cache(folder.path());
    const auto first = solved_with(cache, lit_room()), again = solved_with(cache, lit_room());
    CHECK(again.work.rays == first.work.rays);
    CHECK(again.work.links == first.work.links);
    CHECK(again.work.error == first.work.error);
    CHECK(again.rows_before.least == first.rows_before.least);
    CHECK(again.rows_after.mean == first.rows_after.mean);
    CHECK(again.solution.solver == "shooting");
    CHECK(again.solution.unshot == first.solution.unshot);
    CHECK(again.solution.iterations == first.solution.iterations);
    CHECK(again.solution.residuals == first.solution.residuals);
    CHECK(again.solution.residual == first.solution.residual);
    CHECK(again.solution.error_bound == first.solution.error_bound);
    CHECK(again.vertices == first.vertices);
}

TEST_CASE("a damaged or foreign file of the cache is rebuilt, with a sentence, and the answer is the same") {
    for (const std::string step : {"form_factors", "solution"}) {
        const ScratchFolder folder;
        RadiosityCache first(folder.path());
        const auto truth = solved_with(first, lit_room());
        const fs::path file = file_of(folder.path(), step);
        const std::string whole = read_file(file);
        std::string flipped = whole, other_head = whole, longer = whole + "more", many = whole;
        flipped[whole.size() / 2] ^= 1;
        other_head[0] = 'R';
        for (std::size_t i = 0; i < 8; ++i) many[other_head.find('\n') + 5 + i] = '\x7f';  // a count
        for (const std::string& bytes : {flipped, other_head, longer, many, whole.substr(0, whole.size() / 2),
                                         std::string("a note"), std::string()}) {
            INFO(step << ", " << bytes.size() << " of " << whole.size() << " bytes");
            write_file(file, bytes);
            RadiosityCache cache(folder.path());
            const auto again = solved_with(cache, lit_room());
            CHECK(again.solution.radiosity == truth.solution.radiosity);
            REQUIRE(cache.sentences().size() == 1);
            CHECK_THAT(cache.sentences()[0],
                       Catch::StartsWith("rebuilt ") && Catch::Contains(file.filename().string()));
            CHECK(again.reused.form_factors == (step == "solution"));
            CHECK(again.reused.solution == (step == "form_factors"));
            CHECK(read_file(file).size() == whole.size());
            RadiosityCache rebuilt(folder.path());
            CHECK(solved_with(rebuilt, lit_room()).reused.form_factors);
            CHECK(rebuilt.sentences().empty());
        }
    }
}

TEST_CASE("a cache makes its folder, and refuses a path that is none") {
    const ScratchFolder folder;
    const fs::path inside = folder.path() / "a" / "b";
    RadiosityCache cache(inside);
    solved_with(cache, lit_room());
    CHECK(solved_with(cache, lit_room()).reused.solution);
    write_file(folder.path() / "file", "");
    CHECK_THROWS_WITH(RadiosityCache(folder.path() / "file"), Catch::Contains("folder"));
}

TEST_CASE("content hashes are XXH3's of 128 bits, in whatever pieces the bytes come") {
    const auto hash = [](std::string_view text, std::size_t piece) {
        ContentHash result;
        for (; text.size() > piece; text.remove_prefix(piece)) result.add(text.substr(0, piece));
        result.add(text);
        return result.digits();
    };
    // As xxhsum -H2 prints them.
    CHECK(hash("", 1) == "99aa06d3014798d86001c324468d497f");
    CHECK(hash("abc", 3) == "06b05ab6733a618578af5f94892f3950");
    for (const std::size_t piece : {1, 7, 64, 1000})
        CHECK(hash(std::string(1000, 'a'), piece) == "b01da365eddaa29cb3e7af627147db7c");
}
