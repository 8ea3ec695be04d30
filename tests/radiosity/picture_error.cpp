#include "catch.h"
#include "rooms.h"

#include "raylab/radiosity/radiosity_within.h"
#include "raylab/scene/mean_of_channels.h"

#include <cmath>
#include <numbers>

using namespace raylab;

namespace {

// A room whose ceiling shines, with a plate that throws a shadow onto the floor.
Scene room_with_plate() {
    Scene scene = cube_room(0.5);
    scene.materials[1].emission = Color(1);
    scene.objects.push_back(
        {.shape = float_rectangle({0.25f, 0.5f, 0.25f}, {0.4f, 0, 0}, {0, 0, 0.4f}), .front = 0, .back = 0});
    return scene;
}

// How far what is shown is from a finer solution's patches, relative to their mean, as picture_error() counts it.
double true_error(const RadiosityView& view, const SceneRadiosity& fine) {
    double sum = 0, mean = 0, area = 0;
    for (std::size_t i = 0; i < fine.mesh->patches.size(); ++i) {
        const Patch& patch = fine.mesh->patches[i];
        if (fine.mesh->material(patch).emission != Color(0)) continue;
        const auto at = patch_at(view.mesh, fine.mesh->occluder(patch), patch.side, patch.center);
        const double truth = mean_of_channels(fine.solution.radiosity[i]);
        sum += patch.area * std::pow(mean_of_channels(interpolated_radiosity(view, at)) - truth, 2);
        mean += patch.area * truth;
        area += patch.area;
    }
    return std::sqrt(sum * area) / mean;
}

}  // namespace

TEST_CASE("a picture's error is estimated to a third of itself, coarse and fine, by a matrix and by links") {
    const Scene scene = room_with_plate();
    const auto fine = scene_radiosity(scene, {.edge = 1.0 / 16});
    for (const double edge : {0.5, 0.25}) {
        const auto solved = scene_radiosity(scene, {.edge = edge});
        INFO("edge " << edge);
        CHECK(picture_error(solved.view(), 0).relative == Approx(true_error(solved.view(), fine)).epsilon(0.33));
    }
    for (const double tolerance : {0.3, 0.1}) {
        const auto solved = scene_hierarchy(scene, {.edge = 1.0 / 32, .solving = {.error = tolerance}});
        INFO("links of " << tolerance);
        CHECK(picture_error(solved.view(), 0).relative == Approx(true_error(solved.view(), fine)).epsilon(0.33));
    }
}

TEST_CASE("an estimate sees an error that is in a small part of the surfaces") {
    Scene scene = room_with_plate();
    scene.objects.pop_back();  // then patches are wrong where walls meet the ceiling that shines, and hardly elsewhere
    for (auto& face : scene.objects) face.sides = Sides::both;  // ... nor outside of the room, where it is dark
    const auto solved = scene_radiosity(scene, {.edge = 0.1});
    const auto fine = scene_radiosity(scene, {.edge = 0.05});
    CHECK(picture_error(solved.view(), 0).relative == Approx(true_error(solved.view(), fine)).epsilon(0.25));
}

TEST_CASE("radiosities that are a tenth too small are estimated to be wrong by a tenth") {
    Scene scene = room_with_plate();
    scene.objects.pop_back();
    auto solved = scene_radiosity(scene, {.edge = 0.125});
    const double before = picture_error(solved.view(), 0).relative;
    CHECK(before < 0.03);
    for (std::size_t i = 0; i < solved.solution.radiosity.size(); ++i) {  // but for what is emitted
        const Color emitted = std::numbers::pi * solved.mesh->material(solved.mesh->patches[i]).emission;
        solved.solution.radiosity[i] = emitted + 0.9 * (solved.solution.radiosity[i] - emitted);
    }
    double sum = 0, squares = 0, area = 0;
    for (std::size_t i = 0; i < solved.mesh->patches.size(); ++i) {
        const Patch& patch = solved.mesh->patches[i];
        if (solved.mesh->material(patch).emission != Color(0)) continue;
        const double shown = solved.solution.radiosity[i].r;
        sum += patch.area * shown;
        squares += patch.area * shown * shown;
        area += patch.area;
    }
    for (Color& b : solved.vertices) b *= 0.9;
    const double tenth = std::sqrt(squares / area) / (sum / area) / 9;
    CHECK(picture_error(solved.view(), 0).relative == Approx(tenth).epsilon(0.2));
}

TEST_CASE("an estimate of a picture's error is the same bits for any number of threads", "[threads]") {
    const auto solved = scene_radiosity(room_with_plate(), {.edge = 0.5});
    CHECK(picture_error(solved.view(), 1).relative == picture_error(solved.view(), 4).relative);
}

TEST_CASE("a scene is solved within the error that is asked, and it is so against a finer solution") {
    const Scene scene = room_with_plate();
    const auto fine = scene_radiosity(scene, {.edge = 1.0 / 16});
    for (const double error : {0.15, 0.06}) {
        INFO("error " << error);
        const auto within = radiosity_within(scene, error, {}, {});
        const auto view = std::visit([](const auto& solved) { return solved.view(); }, within.solved);
        CHECK(within.error.relative <= error);
        CHECK(within.attempts.back().error == within.error.relative);
        CHECK(true_error(view, fine) < 1.2 * error);
    }
    CHECK_THROWS_WITH(radiosity_within(scene, 0, {}, {}), Catch::Contains("an error over 0"));
}
