#include "catch.h"
#include "rooms.h"

#include "raylab/radiosity/adaptive_radiosity.h"

#include <numbers>

using namespace raylab;

namespace {

// A floor below a plate and a point light: one sharp shadow, a square around the middle.
constexpr double half_shadow = 0.23;
Scene shadow_on_floor() {
    Scene scene = cube_room(0.5);
    scene.objects.resize(1);
    scene.objects.push_back(
        {.shape = float_rectangle({0.385f, 0.5f, 0.385f}, {0, 0, 0.23f}, {0.23f, 0, 0}), .front = 1, .back = 1});
    scene.materials[1].diffuse = Color(0);
    scene.lights = {{.kind = PointLight{{0.5, 1, 0.5}}, .color = Color(1)}};
    return scene;
}

SceneRadiosityOptions down_to(double edge) { return {.edge = edge, .form_factors = {.rays = 8}}; }

// The share of the floor that is shown on the wrong side of the mean of light and shadow.
double wrong_share(const SceneRadiosity& solved) {
    int wrong = 0, all = 0;
    const double lit = solved.solution.radiosity[patch_at(*solved.mesh, 0, FacetSide::front, {0.15, 0, 0.5}).patch].r;
    constexpr int points = 400;
    for (int x = 0; x < points; ++x)
        for (int z = 0; z < points; ++z) {
            const Vec3d at{(x + 0.5) / points, 0, (z + 0.5) / points};
            const PatchPlace place = patch_at(*solved.mesh, 0, FacetSide::front, at);
            const bool is_shadow = std::max(std::abs(at.x - 0.5), std::abs(at.z - 0.5)) < half_shadow;
            const bool is_dark = solved.solution.radiosity[place.patch].r < 0.4 * lit;
            wrong += is_shadow != is_dark;
            ++all;
        }
    return static_cast<double>(wrong) / all;
}

}  // namespace

TEST_CASE("patches are small where the light changes and large where it does not") {
    const double smallest = 0.015;
    const auto solved = adaptive_radiosity(shadow_on_floor(), down_to(smallest), 0.3);
    double in_shadow = 1, at_edge = 1;  // the longest side of the patch there
    for (const Patch& patch : solved.mesh->patches) {
        if (solved.mesh->model.facets[patch.facet].object != 0) continue;
        const Vec3d from_middle = glm::abs(patch.center - Vec3d{0.5, 0, 0.5});
        const double side = longest_side(patch), apart = std::max(from_middle.x, from_middle.z);
        if (std::abs(apart - half_shadow) < side / 4) at_edge = std::min(at_edge, side);
        if (apart < side / 2) in_shadow = std::min(in_shadow, side);
    }
    CHECK(at_edge < 2 * smallest);
    CHECK(in_shadow > 6 * smallest);
}

TEST_CASE("a shadow by patches that adapt is as sharp as by three times as many equal ones") {
    const Scene scene = shadow_on_floor();
    const auto adaptive = adaptive_radiosity(scene, down_to(0.015), 0.3);
    const auto uniform = scene_radiosity(scene, {.edge = 0.0278, .form_factors = {.rays = 8}});
    CHECK(longest_side(uniform.mesh->patches[0]) == Approx(1.0 / 36));  // the smallest of the others
    CHECK(wrong_share(uniform) < 0.02);
    CHECK(wrong_share(adaptive) == Approx(wrong_share(uniform)).margin(1e-3));
    CHECK(3 * adaptive.mesh->patches.size() < uniform.mesh->patches.size());
}

TEST_CASE("a white furnace is as bright everywhere, so no patch of it is quartered") {
    Scene scene = cube_room(0.7);
    for (Material& material : scene.materials) material.emission = Color(1 / std::numbers::pi);
    SceneRadiosityOptions options{.edge = 1.0 / 16, .form_factors = {.method = "polygon", .rays = 0}};
    options.rows = SceneRadiosityOptions::Rows::raw;
    CHECK(adaptive_radiosity(scene, options, 0.01).mesh->patches.size() == 6 * 4);
}

TEST_CASE("of patches that adapt form factors are reciprocal, and rows of a closed room sum to 1") {
    Scene scene = cube_room(0.5);
    scene.materials[0].emission = Color(1);
    SceneRadiosityOptions options{.edge = 0.06};
    options.rows = SceneRadiosityOptions::Rows::raw;
    const auto solved = adaptive_radiosity(scene, options, 0.3);
    CHECK(solved.mesh->hanging.size() > 10);
    CHECK(std::abs(solved.rows_before.least - 1) < solved.work.error);
    CHECK(std::abs(solved.rows_before.largest - 1) < solved.work.error);
}

TEST_CASE("form factors between patches that stay are computed once, and are those of the last mesh") {
    Scene scene = cube_room(0.5);
    scene.materials[0].emission = Color(1);
    scene.objects.push_back(
        {.shape = float_rectangle({0.3f, 0.4f, 0.3f}, {0, 0, 0.4f}, {0.4f, 0, 0}), .front = 1, .back = 1});
    // Without shadow rays, whose points differ between meshes: the same to the last digits.
    SceneRadiosityOptions options{.edge = 0.06, .form_factors = {.rays = 0}};
    auto adapted = adaptive_radiosity(scene, options, 0.3);
    const auto anew = mesh_radiosity(scene, *adapted.mesh, options);
    CHECK(adapted.mesh->hanging.size() > 10);
    for (std::size_t i = 0; i < anew.solution.radiosity.size(); ++i)
        CHECK(adapted.solution.radiosity[i].g == Approx(anew.solution.radiosity[i].g).epsilon(1e-9));
    options.form_factors.rays = 8;
    adapted = adaptive_radiosity(scene, options, 0.3);
    CHECK(static_cast<double>(adapted.work.rays) <
          1.5 * static_cast<double>(mesh_radiosity(scene, *adapted.mesh, options).work.rays));
}

TEST_CASE("a difference of patches that is not over 0 is refused") {
    CHECK_THROWS_WITH(adaptive_radiosity(shadow_on_floor(), down_to(0.1), 0),
                      Catch::Contains("a difference over 0") && Catch::Contains("found 0"));
}
