#include "catch.h"
#include "rooms.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <numbers>

using namespace raylab;

namespace {

SceneRadiosityOptions exact(double edge) {
    return {.edge = edge,
            .form_factors = {.method = "polygon", .rays = 1},
            .rows = SceneRadiosityOptions::Rows::raw,
            .solving = {.residual = 1e-13}};
}

}  // namespace

TEST_CASE("a cube with one face that emits has the radiosities that ACCURACY names") {
    struct Truth {
        double reflectance, emitter, opposite, side;
    };
    for (const auto& [rho, emitter, opposite, side] : {Truth{.5, 1.090909098108, .1817458261078, .1818362689461},
                                                       Truth{.8, 1.551724153645, .6895510707376, .6896811939044},
                                                       Truth{.9, 2.372881374826, 1.525310551125, 1.525452018512},
                                                       Truth{.99, 17.3622704726, 16.52742512772, 16.52757609992}}) {
        Scene scene = cube_room(rho);
        scene.materials[1].emission = Color(1 / std::numbers::pi);
        const auto solved = scene_radiosity(scene, exact(1));
        REQUIRE(solved.solution.radiosity.size() == 6);
        CHECK(solved.solution.radiosity[1].r == Approx(emitter).epsilon(1e-9));
        CHECK(solved.solution.radiosity[0].g == Approx(opposite).epsilon(1e-9));
        for (const int wall : {2, 3, 4, 5}) CHECK(solved.solution.radiosity[wall].b == Approx(side).epsilon(1e-9));
    }
}

TEST_CASE("a white furnace is equally bright everywhere, however it is cut into patches") {
    Scene scene = cube_room(0.7);
    for (Material& material : scene.materials) material.emission = Color(1 / std::numbers::pi);
    for (const double edge : {1.0, 0.5, 0.34}) {
        const auto solved = scene_radiosity(scene, exact(edge));
        for (const Color& b : solved.solution.radiosity) CHECK(b.r == Approx(1 / 0.3).epsilon(1e-9));
    }
}

TEST_CASE("the default form factors of a closed room sum to 1 within their stated error") {
    Scene scene = cube_room(0.5);
    scene.materials[0].emission = Color(1);
    const auto solved = scene_radiosity(scene, {.edge = 0.2, .rows = SceneRadiosityOptions::Rows::raw});
    CHECK(solved.work.error < 0.006);
    CHECK(std::abs(solved.rows_before.least - 1) < solved.work.error);
    CHECK(std::abs(solved.rows_before.largest - 1) < solved.work.error);
}

TEST_CASE("a wall between two plates hides one from the other") {
    Scene scene = cube_room(0.5);
    scene.materials[0].emission = Color(1);
    scene.objects.push_back({.shape = float_rectangle({0, 0.5f, 0}, {1, 0, 0}, {0, 0, 1}), .front = 1, .back = 1});
    const auto solved = scene_radiosity(scene, exact(1));
    CHECK(solved.system.form_factors.at(0, 1) == 0);  // floor to ceiling
    CHECK(solved.system.form_factors.at(1, 0) == 0);
    CHECK(solved.solution.radiosity[1].r > 0);  // by way of the walls, which reach past it
}

TEST_CASE("what is seen from one side only stops light from either side, so that reciprocity holds") {
    Scene scene = cube_room(0.5);
    scene.materials[0].emission = Color(1);
    for (const Sides sides : {Sides::front, Sides::back}) {
        scene.objects.resize(6);
        scene.objects.push_back(
            {.shape = float_rectangle({0, 0.5f, 0}, {1, 0, 0}, {0, 0, 1}), .front = 1, .back = 1, .sides = sides});
        const auto solved = scene_radiosity(scene, exact(1));
        CHECK(solved.system.form_factors.at(0, 1) == 0);  // floor to ceiling
        CHECK(solved.system.form_factors.at(1, 0) == 0);
    }
}

TEST_CASE("scaling does not bring back light that leaves through an open side, however few shadow rays are cast") {
    Scene scene = cube_room(0.5);
    scene.materials[1].emission = Color(1);
    scene.objects.erase(scene.objects.begin() + 4);  // a wall
    scene.objects.push_back({.shape = Sphere{{0.5f, 0.4f, 0.5f}, 0.3f}, .front = 0, .back = 0, .sides = Sides::front});
    for (const int rays : {1, 4, 64}) {
        const auto solved = scene_radiosity(scene, {.edge = 0.25, .form_factors = {.rays = rays}});
        CHECK(solved.work.error_in_full_view < 0.006);
        CHECK(solved.rows_after.least < solved.rows_before.least + solved.work.error_in_full_view);
        CHECK(solved.rows_after.mean < solved.rows_before.mean + solved.work.error_in_full_view);
    }
}

// One convention of brightness: a light's colour is the radiance it gives a white surface that faces it.
TEST_CASE("a light in black surroundings gives the same picture by Whitted's tracer and by radiosity") {
    Scene scene = cube_room(0);
    scene.objects.resize(1);
    scene.materials[0].diffuse = Color(0.6, 0.5, 0.4);
    scene.materials[0].ambient = Color(0);
    scene.camera.position = {0.5, 3, 0.5};
    scene.camera.target = {0.5, 0, 0.5};
    scene.camera.up = {0, 0, 1};
    scene.camera.projection = Orthographic{0.9};
    scene.image = {16, 16};
    for (const auto& kind : std::vector<std::variant<PointLight, SpotLight, DistantLight>>{
             PointLight{{0.3, 1.5, 0.4}}, SpotLight{{0.3, 1.5, 0.4}, {0.5, 0, 0.5}, 60, 2},
             DistantLight{{1, -2, 0.5}}}) {
        scene.lights = {{.kind = kind, .color = Color(0.9, 0.8, 0.7)}};
        const CameraFrame frame = camera_frame(scene.camera, scene.image);
        const auto solved = scene_radiosity(scene, {.edge = 0.04, .form_factors = {.rays = 0}});
        const Image rays = whitted_picture(scene, *make_accelerator("auto", scene), frame);
        const Image patches = radiosity_picture(solved.view(), frame, RadiosityShading::vertices, {});
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                INFO("pixel " << x << ", " << y);
                CHECK(patches.at(x, y).r == Approx(rays.at(x, y).r).epsilon(0.01));
                CHECK(patches.at(x, y).b == Approx(rays.at(x, y).b).epsilon(0.01));
            }
    }
}

TEST_CASE("the background sends its light through what no surface fills") {
    Scene scene = cube_room(0.5);
    scene.objects.resize(1);
    scene.background.color = Color(0.2, 0.4, 0.6);
    const auto solved = scene_radiosity(scene, exact(1));
    CHECK(solved.solution.radiosity[0].g == Approx(0.5 * std::numbers::pi * 0.4).epsilon(1e-12));
}

TEST_CASE("the background does not light the floor below a box that has no bottom") {
    Scene scene = cube_room(0.5);
    scene.objects.resize(1);
    add_box_without_bottom(scene);
    scene.background.color = Color(1);
    const auto solved = scene_radiosity(scene, {.edge = 0.125});
    for (std::size_t i = 0; i < solved.mesh->patches.size(); ++i) {
        const Vec3d& at = solved.mesh->patches[i].center;
        const bool below = at.y == 0 && std::max(std::abs(at.x - 0.5), std::abs(at.z - 0.5)) < 0.25;
        const double lit = solved.solution.radiosity[i].r;
        if (below)
            CHECK(lit == 0);
        else
            CHECK(lit > 0.5);
    }
}

TEST_CASE("radiosities are the same bits for any number of threads", "[threads]") {
    Scene scene = cube_room(0.6);
    scene.materials[0].emission = Color(1, 2, 3);
    scene.objects.push_back({.shape = Sphere{{0.5f, 0.4f, 0.5f}, 0.2f}, .front = 1, .back = 1, .sides = Sides::front});
    SceneRadiosityOptions options{.edge = 0.25};
    options.form_factors.threads = 1;
    const auto one = scene_radiosity(scene, options);
    options.form_factors.threads = 4;
    const auto four = scene_radiosity(scene, options);
    CHECK(one.solution.radiosity == four.solution.radiosity);
    CHECK(one.work.error == four.work.error);
}

TEST_CASE("what cannot be solved is refused with what was expected") {
    Scene dark = cube_room(0.5), white = cube_room(1), empty = cube_room(0.5);
    white.materials[1].emission = Color(1);
    empty.objects.clear();
    CHECK_THROWS_WITH(scene_radiosity(dark, exact(1)), Catch::Contains("cube.toml") && Catch::Contains("a light"));
    CHECK_THROWS_WITH(scene_radiosity(white, exact(1)), Catch::Contains("less than 1 in each channel"));
    CHECK_THROWS_WITH(scene_radiosity(empty, exact(1)), Catch::Contains("at least one surface"));
    SceneRadiosityOptions small = exact(0.05);
    small.limit.bytes = 1000;
    CHECK_THROWS_WITH(scene_radiosity(cube_room(0.5), small), Catch::Contains("--memory"));
    SceneRadiosityOptions unknown = exact(1);
    unknown.form_factors.method = "contuor";
    Scene lit = cube_room(0.5);
    lit.materials[0].emission = Color(1);
    CHECK_THROWS_WITH(scene_radiosity(lit, unknown), Catch::Contains("did you mean \"contour\""));
    SceneRadiosityOptions odd = exact(1);
    odd.form_factors = {.method = "hemicube", .effort = 3};
    CHECK_THROWS_WITH(scene_radiosity(lit, odd), Catch::Contains("expected an even number of pixels"));
}
