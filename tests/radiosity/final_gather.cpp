#include "catch.h"
#include "rooms.h"

#include "raylab/radiosity/final_gather.h"
#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/radiosity/scene_radiosity.h"

#include <numbers>

using namespace raylab;

namespace {

// A floor of reflectance one half, alone.
Scene floor_alone() {
    Scene scene = cube_room(0.5);
    scene.objects.resize(1);
    return scene;
}

}  // namespace

TEST_CASE("a gather at a point has what a polygon sends there in closed form, whatever the polygon's patches") {
    Scene scene = floor_alone();
    const std::vector<Vec3d> light{{0.2, 0.5, 0.3}, {0.6, 0.5, 0.3}, {0.6, 0.5, 0.8}, {0.2, 0.5, 0.8}};
    scene.materials[1] = {.diffuse = Color(0), .emission = Color(2)};
    scene.objects.push_back({.shape = float_rectangle({0.2f, 0.5f, 0.3f}, {0.4f, 0, 0}, {0, 0, 0.5f}),
                             .front = 1,
                             .back = 1,
                             .sides = Sides::front});
    const auto solved = scene_radiosity(scene, {.edge = 0.13, .form_factors = {.rays = 0}});
    const RadiosityView view = solved.view();
    const FinalGather gather(view);
    Traversal traversal;
    for (const Vec3d point : {Vec3d{0.31, 0, 0.44}, Vec3d{0.9, 0, 0.05}}) {
        const auto at = patch_at(*solved.mesh, 0, FacetSide::front, point);
        const auto found = gather.at(at.patch, point, {}, traversal);
        const double factor = contour_form_factor(point, {0, 1, 0}, light);
        CHECK(found.filled == Approx(factor).epsilon(1e-6));  // corners are floats
        CHECK(found.radiosity.g == Approx(0.5 * 2 * std::numbers::pi * factor).epsilon(1e-6));
    }
}

TEST_CASE("a gather at a point has the light of point lights there, not the patch's mean") {
    Scene scene = floor_alone();
    scene.lights = {{.kind = PointLight{{0.5, 0.25, 0.5}}, .color = Color(1)}};
    const auto solved = scene_radiosity(scene, {.edge = 1, .form_factors = {.rays = 0}});
    const RadiosityView view = solved.view();
    Traversal traversal;
    const double below = FinalGather(view).at(0, {0.5, 0, 0.5}, {}, traversal).radiosity.r,
                 aside = FinalGather(view).at(0, {1, 0, 0.5}, {}, traversal).radiosity.r;
    CHECK(below == Approx(0.5 * std::numbers::pi).epsilon(1e-6));
    CHECK(aside / below == Approx(0.25 / std::hypot(0.5, 0.25)).epsilon(1e-6));  // the cosine: light is not attenuated
}

// Of a floor that faces the sky the share of the horizon's colour is 2 m (1 - m)^4 over the cosine m, which integrates
// to 1/15; a wall sees the horizon's colour alone below it.
TEST_CASE("a sky whose zenith differs gives each surface what it sees of it") {
    Scene scene = floor_alone();
    scene.background.color = Color(0.3);
    scene.background.zenith = Color(0.9);
    const double sky = std::numbers::pi * (0.3 / 15 + 0.9 * 14 / 15);
    const auto solved = scene_radiosity(scene, {.edge = 1, .form_factors = {.rays = 0}});
    CHECK(solved.solution.radiosity[0].g == Approx(0.5 * sky).epsilon(0.01));
    const RadiosityView view = solved.view();
    Traversal traversal;
    CHECK(FinalGather(view).at(0, {0.5, 0, 0.5}, {}, traversal).radiosity.g == Approx(0.5 * sky).epsilon(0.01));
    const auto linked = scene_hierarchy(scene, {.edge = 0.25});
    for (const Color& b : linked.patches) CHECK(b.g == Approx(0.5 * sky).epsilon(0.03));  // 16 rays

    scene.objects[0].shape = float_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});  // a wall
    const auto wall = scene_radiosity(scene, {.edge = 1, .form_factors = {.rays = 0}});
    CHECK(wall.solution.radiosity[0].g < 0.5 * 0.8 * sky);
    CHECK(wall.solution.radiosity[0].g > 0.5 * std::numbers::pi * 0.5 * (0.3 + 0.6));
}
