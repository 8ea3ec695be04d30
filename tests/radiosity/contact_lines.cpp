#include "catch.h"
#include "rooms.h"

#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/radiosity/mesh/contact_lines.h"
#include "raylab/radiosity/scene_radiosity.h"

#include <numbers>

using namespace raylab;

namespace {

// A floor, a wall across it at x = 0.45 from end to end, and a light on one side of the wall, below its upper edge.
Scene wall_on_floor() {
    Scene scene = cube_room(0.5);
    scene.objects.resize(1);
    scene.materials[1].diffuse = Color(0);
    scene.objects.push_back({.shape = float_rectangle({0.45f, 0, -0.5f}, {0, 0, 2}, {0, 1, 0}), .front = 1, .back = 1});
    scene.lights = {{.kind = PointLight{{0.2, 0.3, 0.5}}, .color = Color(1)}};
    return scene;
}

// The power that the floor behind the wall shows, interpolated between vertices; nothing arrives there.
double leaked(const RadiosityView& view) {
    constexpr int points = 200;
    double sum = 0;
    for (int x = 0; x < points; ++x)
        for (int z = 0; z < points; ++z) {
            const Vec3d at{0.45 + 0.55 * (x + 0.5) / points, 0, (z + 0.5) / points};
            const PatchPlace place = patch_at(view.mesh, 0, FacetSide::front, at);
            sum += interpolated_radiosity(view, place).r;
        }
    return sum * 0.55 / (points * points);
}

// The wall is black, so nothing hides the floor from what it exchanges light with: no shadow rays but to the light.
double leaked_by_patches(double edge, MeshLines lines) {
    const auto solved = scene_radiosity(
        wall_on_floor(), {.edge = edge, .lines = lines, .form_factors = {.rays = 0}, .light_points = 256});
    return leaked(solved.view());
}

double leaked_by_links(MeshLines lines) {
    const auto solved = scene_hierarchy(
        wall_on_floor(), {.edge = 0.1, .lines = lines, .solving = {.error = 0.05, .rays = 0, .light_points = 64}});
    return leaked(solved.view());
}

double area_of(const PolygonalModel& model) {
    double sum = 0;
    for (const Facet& facet : model.facets) {
        const auto& c = facet.corners;
        for (std::size_t i = 2; i < c.size(); ++i) sum += glm::length(cross(c[i - 1] - c[0], c[i] - c[0])) / 2;
    }
    return sum;
}

}  // namespace

TEST_CASE("light leaks under a wall in proportion to the size of patches, and not where they end at its line") {
    const double coarse = leaked_by_patches(0.1, MeshLines::none), fine = leaked_by_patches(0.025, MeshLines::none);
    CHECK(coarse > 0.005);
    CHECK(fine < 0.5 * coarse);
    CHECK(fine > 0.1 * coarse);
    CHECK(leaked_by_patches(0.1, MeshLines::contact) == 0);
    CHECK(leaked_by_links(MeshLines::none) > 0.005);
    CHECK(leaked_by_links(MeshLines::contact) == 0);
}

TEST_CASE("contact lines cut a floor along the walls of a box that stands on it, and lose no area") {
    Scene scene = cube_room(0.5);
    scene.objects.resize(1);
    // A turned box without a bottom.
    const Vec3f x{0.3f, 0, 0.1f}, y{0, 0.4f, 0}, z{-0.1f, 0, 0.3f}, corner{0.4f, 0, 0.3f};
    for (const Polygon& side : {float_rectangle(corner, x, y), float_rectangle(corner, z, y),
                                float_rectangle(corner + x, z, y), float_rectangle(corner + z, x, y)})
        scene.objects.push_back({.shape = side, .front = 0, .back = 0});
    const PolygonalModel model = polygonal_model(scene, 1), cut = with_contact_lines(model);
    CHECK(area_of(cut) == Approx(area_of(model)).epsilon(1e-6));
    // No facet of the floor lies on both sides of a wall.
    const Vec3d a = convert<double>(corner), u = convert<double>(x), v = convert<double>(z);
    std::size_t inside = 0;
    for (const Facet& facet : cut.facets) {
        if (facet.object != 0) continue;
        int in = 0, out = 0;
        for (const Vec3d& at : facet.corners) {
            const double s = dot(at - a, u) / dot(u, u), t = dot(at - a, v) / dot(v, v), e = 1e-5;
            in += s > e && s < 1 - e && t > e && t < 1 - e;
            out += s < -e || s > 1 + e || t < -e || t > 1 + e;
        }
        CHECK((in == 0 || out == 0));
        Vec3d middle{0, 0, 0};
        for (const Vec3d& at : facet.corners) middle += at / static_cast<double>(facet.corners.size());
        const double s = dot(middle - a, u) / dot(u, u), t = dot(middle - a, v) / dot(v, v);
        inside += s > 0 && s < 1 && t > 0 && t < 1;
    }
    CHECK(inside == 1);
}

TEST_CASE("a wall that only comes near a floor cuts nothing, and one that ends on it cuts no farther piece") {
    Scene scene = cube_room(0.5);
    scene.objects.resize(1);
    scene.objects.push_back({.shape = float_rectangle({0.4f, 0.01f, 0.2f}, {0, 0, 0.3f}, {0, 1, 0}), .front = 0});
    const PolygonalModel near = polygonal_model(scene, 1);
    CHECK(with_contact_lines(near).facets.size() == near.facets.size());
    scene.objects[1].shape = float_rectangle({0.4f, 0, 0.2f}, {0, 0, 0.3f}, {0, 1, 0});
    CHECK(with_contact_lines(polygonal_model(scene, 1)).facets.size() == near.facets.size() + 1);
    // A second wall stands on the right part alone.
    scene.objects.push_back({.shape = float_rectangle({0.6f, 0, 0.5f}, {0.2f, 0, 0}, {0, 1, 0}), .front = 0});
    std::size_t floor = 0;
    for (const Facet& facet : with_contact_lines(polygonal_model(scene, 1)).facets) floor += facet.object == 0;
    CHECK(floor == 3);
}
