#include "catch.h"
#include "rooms.h"

#include "raylab/base/file.h"
#include "raylab/base/temporary.h"
#include "raylab/radiosity/hierarchical_scene.h"

#include <filesystem>
#include <functional>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

// A room with a screen in it, so that shadow rays decide about links.
Scene screened_room() {
    Scene scene = cube_room(0.5);
    scene.materials[1].emission = Color(1);
    scene.objects.push_back({.shape = float_rectangle({0.3f, 0.4f, 0.3f}, {0, 0, 0.4f}, {0.4f, 0, 0})});
    return scene;
}

SceneHierarchy solved_with(RadiosityCache* cache, const Scene& scene, int rays = 4) {
    return scene_hierarchy(scene,
                           {.edge = 0.1, .solving = {.error = 0.1, .rays = rays, .residual = 1e-3}, .cache = cache});
}

fs::path file_of(const fs::path& folder, const std::string& step) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(step)) return entry.path();
    FAIL("no file of the step " + step);
    return {};
}

}  // namespace

TEST_CASE("links outlive what light does, the solution the camera alone, and the answer is that without a cache") {
    struct Row {
        std::string change;
        std::function<void(Scene&)> make;
        bool links, solution;
    };
    const std::vector<Row> rows{
        {"nothing", [](Scene&) {}, false, true},
        {"camera",
         [](Scene& scene) {
             scene.camera.position = {0.5, 0.5, 0.1};
         },
         false, true},
        {"emission", [](Scene& scene) { scene.materials[1].emission = Color(2, 1, 1); }, true, false},
        {"reflectance", [](Scene& scene) { scene.materials[3].diffuse = Color(0.5, 0.6, 0.5); }, true, false},
        {"another emitter", [](Scene& scene) { scene.materials[2].emission = Color(3); }, true, false},
        {"a light",
         [](Scene& scene) {
             scene.lights = {{.kind = PointLight{{0.5, 0.5, 0.5}}}};
         },
         true, false},
        {"background", [](Scene& scene) { scene.background.color = Color(1); }, true, false},
        {"a wall moved",
         [](Scene& scene) {
             scene.objects[5].shape = float_rectangle({0, 0, 1.25f}, {0, 1, 0}, {1, 0, 0});
         },
         false, false}};
    for (const Row& row : rows) {
        INFO(row.change);
        const ScratchFolder folder;
        RadiosityCache cache(folder.path());
        Scene scene = screened_room();
        CHECK(solved_with(&cache, scene).reused.links == 0);
        row.make(scene);
        const auto again = solved_with(&cache, scene), alone = solved_with(nullptr, scene);
        CHECK(again.patches == alone.patches);
        CHECK(again.vertices == alone.vertices);
        CHECK(again.power.lost == alone.power.lost);
        CHECK(again.solution.work.links == alone.solution.work.links);
        CHECK((again.reused.links > again.reused.of / 2) == row.links);
        CHECK(again.reused.solution == row.solution);
        CHECK(cache.sentences().empty());
    }
}

TEST_CASE("what was asked for in one light and in another is known together, and other rays are other links") {
    const ScratchFolder folder;
    RadiosityCache cache(folder.path());
    Scene scene = screened_room(), other = scene;
    other.materials[2].emission = Color(3);
    for (const Scene& one : {scene, other}) solved_with(&cache, one);
    other.materials[2].emission = Color(3.001);  // so that as good as the same is asked
    const auto third = solved_with(&cache, other);
    CHECK(third.reused.of > 0);
    CHECK(100 * third.reused.links > 99 * third.reused.of);
    CHECK(third.solution.work.rays < solved_with(nullptr, other).solution.work.rays / 50);
    CHECK(solved_with(&cache, other, 5).reused.links == 0);
}

TEST_CASE("damaged links and hierarchies are rebuilt, with a sentence, and the answer is the same") {
    for (const std::string step : {"links", "hierarchy"}) {
        const ScratchFolder folder;
        RadiosityCache first(folder.path());
        const auto truth = solved_with(&first, screened_room());
        const fs::path file = file_of(folder.path(), step);
        const std::string whole = read_file(file);
        std::string flipped = whole, many = whole;
        flipped[whole.size() / 2] ^= 1;
        for (std::size_t i = 0; i < 8; ++i) many[many.find('\n') + 5 + i] = '\x7f';  // a count
        for (const std::string& bytes : {flipped, many, whole + "more", whole.substr(0, whole.size() / 2)}) {
            INFO(step << ", " << bytes.size() << " of " << whole.size() << " bytes");
            write_file(file, bytes);
            if (step == "links") fs::remove(file_of(folder.path(), "hierarchy"));  // else links are not asked for
            RadiosityCache cache(folder.path());
            CHECK(solved_with(&cache, screened_room()).patches == truth.patches);
            REQUIRE(cache.sentences().size() == 1);
            CHECK_THAT(cache.sentences()[0], Catch::StartsWith("rebuilt ") && Catch::Contains(step));
            CHECK(read_file(file).size() == whole.size());
        }
    }
}
