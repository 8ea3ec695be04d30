#include "catch.h"

#include "raylab/radiosity/mesh/quartered_mesh.h"
#include "raylab/radiosity/vertex_radiosity.h"

#include <set>

using namespace raylab;

namespace {

Scene scene_with(const Shape& shape, Sides sides) {
    Scene scene;
    scene.materials = {{.name = "white"}};
    scene.objects = {{.shape = shape, .sides = sides}};
    return scene;
}

const Polygon square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
const Polygon skew{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 1.5f, 0}}};
const Triangle triangle{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};

// Quarters the patches that hold a point, some times over: sizes that differ much lie side by side.
PatchMesh quartered_towards(PatchMesh mesh, const Vec3d& point, int times) {
    for (int i = 0; i < times; ++i) {
        std::vector<bool> chosen;
        for (const Patch& patch : mesh.patches)
            chosen.push_back(glm::distance(patch.center, point) <= longest_side(patch));
        mesh = quartered_mesh(std::move(mesh), chosen);
    }
    return mesh;
}

Color interpolated(const PatchMesh& mesh, const Radiosities& vertices, std::uint32_t patch,
                   const std::array<double, 4>& weights) {
    Color sum(0);
    for (std::uint32_t i = 0; i < mesh.patches[patch].corner_count; ++i)
        sum += weights[i] * vertices[mesh.patches[patch].vertices[i]];
    return sum;
}

// The largest difference, over all sides of patches, of what both patches show on the side. A point is asked of either
// side of it, by its distance from the patches' centres.
double largest_crack(const PatchMesh& mesh, const Radiosities& vertices) {
    double crack = 0;
    for (const Patch& patch : mesh.patches)
        for (std::uint32_t i = 0; i < patch.corner_count; ++i) {
            const Vec3d a = patch.corners[i], b = patch.corners[(i + 1) % patch.corner_count];
            for (const double share : {0.25, 0.5, 0.8}) {
                const Vec3d on = glm::mix(a, b, share), off = 1e-9 * glm::normalize(on - patch.center);
                const auto seen = [&](const Vec3d& at) {
                    const PatchPlace place = patch_at(mesh, mesh.occluder(patch), patch.side, at);
                    return interpolated(mesh, vertices, place.patch, place.weights).r;
                };
                crack = std::max(crack, std::abs(seen(on - off) - seen(on + off)));
            }
        }
    return crack;
}

// Radiosities with a step along a slanted line, as a shadow makes it.
Radiosities shadow_on(const PatchMesh& mesh) {
    Radiosities patches;
    for (const Patch& patch : mesh.patches) patches.emplace_back(patch.center.x + 0.4 * patch.center.y < 0.5 ? 1 : 3);
    return patches;
}

}  // namespace

TEST_CASE("quarters have a quarter of the area, the normal, and together the corners and middles") {
    for (const Shape& shape : {Shape{square}, Shape{skew}, Shape{triangle}}) {
        const auto mesh = patch_mesh(scene_with(shape, Sides::both), {.edge = 10});
        for (const Patch& whole : mesh.patches) {
            double area = 0;
            for (const Patch& quarter : quarters(whole)) {
                area += quarter.area;
                CHECK(quarter.level == 1);
                CHECK(glm::distance(quarter.normal, whole.normal) == 0);
                CHECK(longest_side(quarter) <= 0.75 * longest_side(whole));
            }
            CHECK(area == Approx(whole.area).epsilon(1e-12));
        }
    }
}

TEST_CASE("a point is found in the quarter that contains it, with weights that give the point back") {
    for (const Shape& shape : {Shape{square}, Shape{skew}, Shape{triangle}}) {
        const auto mesh =
            quartered_towards(patch_mesh(scene_with(shape, Sides::both), {.edge = 0.9}), {0.3, 0.4, 0}, 4);
        REQUIRE(mesh.patches.size() > 30);
        for (std::uint32_t number = 0; number < mesh.patches.size(); ++number) {
            const Patch& patch = mesh.patches[number];
            for (std::uint32_t corner = 0; corner < patch.corner_count; ++corner) {
                const Vec3d point = glm::mix(patch.center, patch.corners[corner], 0.9);
                const PatchPlace place = patch_at(mesh, mesh.occluder(patch), patch.side, point);
                REQUIRE(place.patch == number);
                Vec3d again{0, 0, 0};
                for (std::uint32_t i = 0; i < patch.corner_count; ++i) again += place.weights[i] * patch.corners[i];
                CHECK(glm::distance(again, point) < 1e-9);
            }
        }
    }
}

TEST_CASE("the quarters of a patch stand where it stood") {
    const auto mesh = patch_mesh(scene_with(square, Sides::front), {.edge = 0.5});
    const auto quartered = quartered_mesh(mesh, {false, true, false, false});
    REQUIRE(quartered.patches.size() == 7);
    CHECK(glm::distance(quartered.patches[0].center, mesh.patches[0].center) == 0);
    CHECK(glm::distance(quartered.patches[6].center, mesh.patches[3].center) == 0);
    for (int quarter = 1; quarter < 5; ++quarter)
        CHECK(glm::distance(quartered.patches[quarter].center, mesh.patches[1].center) < 0.25);
}

TEST_CASE("vertices in the middle of a larger patch's side are known, coarse ones first") {
    const auto mesh = quartered_towards(patch_mesh(scene_with(square, Sides::front), {.edge = 0.5}), {0.4, 0.4, 0}, 3);
    REQUIRE(!mesh.hanging.empty());
    std::set<std::uint32_t> seen, all;
    for (const auto& [vertex, ends] : mesh.hanging) all.insert(vertex);
    for (const auto& [vertex, ends] : mesh.hanging) {
        const Vec3d middle = 0.5 * (mesh.vertices[ends[0]] + mesh.vertices[ends[1]]);
        CHECK(glm::distance(mesh.vertices[vertex], middle) < 1e-9);
        for (const std::uint32_t end : ends) CHECK((all.count(end) == 0 || seen.count(end) == 1));
        seen.insert(vertex);
    }
    CHECK(patch_mesh(scene_with(square, Sides::front), {.edge = 0.1}).hanging.empty());
}

TEST_CASE("T-vertices are cracks in the picture, and none once they are mended") {
    for (const Shape& shape : {Shape{square}, Shape{triangle}}) {
        const auto mesh =
            quartered_towards(patch_mesh(scene_with(shape, Sides::front), {.edge = 0.6}), {0.4, 0.4, 0}, 4);
        const Radiosities patches = shadow_on(mesh);
        CHECK(largest_crack(mesh, vertex_radiosities(mesh, patches, TVertices::left)) > 0.2);
        CHECK(largest_crack(mesh, vertex_radiosities(mesh, patches)) < 1e-6);
    }
}

TEST_CASE("a vertex on the side of a larger patch lies on no border") {
    // The patch in the middle of 25 is quartered, and one quarter is bright. A border would be darkened beside it.
    const auto mesh = patch_mesh(scene_with(square, Sides::front), {.edge = 0.2});
    std::vector<bool> chosen(25);
    chosen[12] = true;
    const auto quartered = quartered_mesh(mesh, chosen);
    Radiosities patches(quartered.patches.size(), Color(1));
    patches[12] = Color(5);
    for (const Color& vertex : vertex_radiosities(quartered, patches)) CHECK(vertex.r >= 1);
}
