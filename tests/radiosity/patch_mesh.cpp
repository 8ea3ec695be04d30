#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/mesh/patch_mesh.h"
#include "raylab/radiosity/mesh/tessellation.h"
#include "raylab/radiosity/vertex_radiosity.h"

#include <numbers>

using namespace raylab;

namespace {

Scene scene_of(std::vector<Object> objects) {
    Scene scene;
    scene.source = "test.toml";
    scene.materials = {{.name = "white"}};
    scene.objects = std::move(objects);
    return scene;
}

Polygon square(float size) { return {{{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}}}; }

double area_of(const PatchMesh& mesh, FacetSide side) {
    double sum = 0;
    for (const Patch& patch : mesh.patches) sum += patch.side == side ? patch.area : 0;
    return sum;
}

// Every shape that can be cut, with its area.
std::vector<std::pair<Shape, double>> shapes_with_areas() {
    const double pi = std::numbers::pi;
    const Polygon arrow{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5f, 0}, {0, 2, 0}}};  // not convex
    return {{Sphere{{1, 2, 3}, 2}, 16 * pi},
            {Cylinder{{0, 0, 0}, {0, 0, 3}, 1, Ends::capped}, 8 * pi},
            {Cylinder{{0, 0, 0}, {1, 1, 1}, 0.5f, Ends::open}, pi * std::sqrt(3.0)},
            {Cone{{0, 0, 0}, {0, 4, 0}, 3, 0, Ends::open}, 15 * pi},
            {Paraboloid{{0, 0, 0}, {0, 0, 2}, 1, Ends::open}, pi / 24 * (std::pow(17, 1.5) - 1)},
            {Disk{{0, 0, 0}, {1, 2, 3}, 2}, 4 * pi},
            {Annulus{{0, 0, 0}, {0, 0, 1}, 1, 2}, 3 * pi},
            {square(3), 9},
            {arrow, 4 - 1.5},
            {Triangle{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, 3}};
}

}  // namespace

TEST_CASE("patches have the area of their shape, on either side, and the more of them the nearer") {
    for (const auto& [shape, area] : shapes_with_areas()) {
        INFO("shape " << shape.index());
        const auto coarse = patch_mesh(scene_of({{.shape = shape}}), {.edge = 0.4});
        const auto fine = patch_mesh(scene_of({{.shape = shape}}), {.edge = 0.1});
        CHECK(area_of(fine, FacetSide::front) == Approx(area).epsilon(2e-3));
        CHECK(area_of(fine, FacetSide::back) == Approx(area_of(fine, FacetSide::front)).epsilon(1e-9));
        CHECK(std::abs(area_of(fine, FacetSide::front) - area) <=
              std::abs(area_of(coarse, FacetSide::front) - area) + 1e-6 * area);
    }
}

TEST_CASE("no side of a flat patch is longer than the edge asked for, and halving the edge makes four times as many") {
    const Scene scene = scene_of({{.shape = square(1)}, {.shape = Triangle{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}});
    for (const double edge : {0.5, 0.25, 0.125}) {
        const auto mesh = patch_mesh(scene, {.edge = edge});
        for (const Patch& patch : mesh.patches)
            for (std::uint32_t i = 0; i < patch.corner_count; ++i)
                CHECK(glm::distance(patch.corners[i], patch.corners[(i + 1) % patch.corner_count]) <= edge * 1.0001);
        const double squares = 1 / (edge * edge), rows = std::ceil(std::sqrt(2.0) / edge);
        CHECK(mesh.patches.size() == Approx(2 * (squares + rows * rows)));
    }
}

TEST_CASE("normals point to the side that a patch is on: outward on the front of a ball, also of a mirrored one") {
    Object mirrored{.shape = Sphere{{0, 0, 0}, 1}};
    mirrored.placement.columns[0] = {-2, 0, 0};
    for (const Object& object : {Object{.shape = Sphere{{0, 0, 0}, 1}}, mirrored}) {
        const auto mesh = patch_mesh(scene_of({object}), {.edge = 0.3});
        for (const Patch& patch : mesh.patches) {
            const bool outward = dot(patch.normal, patch.center) > 0;
            CHECK(outward == (patch.side == FacetSide::front));
        }
    }
}

TEST_CASE("a one-sided shape has patches on that side only") {
    const auto mesh = patch_mesh(scene_of({{.shape = square(1), .sides = Sides::back}}), {.edge = 0.5});
    REQUIRE(mesh.patches.size() == 4);
    for (const Patch& patch : mesh.patches) CHECK((patch.side == FacetSide::back && patch.normal.z == Approx(-1)));
}

TEST_CASE("the patch of a point is the one that contains it, with weights that give the point back") {
    for (const auto& [shape, area] : shapes_with_areas()) {
        INFO("shape " << shape.index());
        const auto mesh = patch_mesh(scene_of({{.shape = shape}}), {.edge = 0.3});
        for (std::uint32_t number = 0; number < mesh.patches.size(); ++number) {
            const Patch& patch = mesh.patches[number];
            for (const double to_corner : {0.0, 0.3, 0.9}) {
                const Vec3d point = glm::mix(patch.center, patch.corners[number % patch.corner_count], to_corner);
                const PatchPlace place = patch_at(mesh, mesh.occluder(patch), patch.side, point);
                REQUIRE(place.patch == number);
                Vec3d again{0, 0, 0};
                for (std::uint32_t i = 0; i < patch.corner_count; ++i) again += place.weights[i] * patch.corners[i];
                CHECK(glm::distance(again, point) < 1e-5);
            }
        }
    }
}

TEST_CASE("a gradient over a square goes on to its border, where patches' means would flatten it") {
    const auto mesh = patch_mesh(scene_of({{.shape = square(1), .sides = Sides::front}}), {.edge = 0.125});
    Radiosities linear;
    for (const Patch& patch : mesh.patches) linear.push_back(Color(1 + patch.center.x));
    const Radiosities vertices = vertex_radiosities(mesh, linear);
    REQUIRE(vertices.size() == 81);
    for (std::size_t i = 0; i < vertices.size(); ++i) CHECK(vertices[i].r == Approx(1 + mesh.vertices[i].x));
}

TEST_CASE("facets of a ball share their vertices, and the sides of a box do not") {
    const auto ball = patch_mesh(scene_of({{.shape = Sphere{{0, 0, 0}, 1}, .sides = Sides::front}}), {.edge = 10});
    CHECK(ball.patches.size() == 12 * 6);
    CHECK(ball.vertices.size() == 12 * 5 + 2);
    Object a{.shape = square(1), .sides = Sides::front}, b = a;
    b.placement.columns = {Vec3f{1, 0, 0}, Vec3f{0, 0, 1}, Vec3f{0, -1, 0}};
    CHECK(patch_mesh(scene_of({a, b}), {.edge = 10}).vertices.size() == 8);
}

TEST_CASE("what has no finite area, and more patches than allowed, are refused by name") {
    CHECK_THROWS_WITH(patch_mesh(scene_of({{.shape = Plane{{0, 0, 0}, {0, 1, 0}}, .path = "plane 0"}}), {.edge = 1}),
                      Catch::Contains("plane 0") && Catch::Contains("an infinite plane"));
    CHECK_THROWS_WITH(patch_mesh(scene_of({{.shape = square(1)}}), {.edge = 0.01}, 1000),
                      Catch::Contains("at most 1000 patches"));
    for (const double edge : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(patch_mesh(scene_of({{.shape = square(1)}}), {.edge = edge}), Error);
}

TEST_CASE("the edge for a number of patches makes as many as possible, and no more") {
    const Scene scene = scene_of({{.shape = square(1), .sides = Sides::front}});
    for (const std::size_t patches : {1u, 4u, 99u, 100u, 101u}) {
        const auto count = patch_mesh(scene, {.edge = edge_for_patches(scene, patches)}).patches.size();
        const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(patches)));
        CHECK(count == side * side);
    }
}
