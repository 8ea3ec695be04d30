#include "catch.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/painters/painters_picture.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/bounds/box.h"

#include <algorithm>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

struct Seen {
    std::string name;
    Scene scene;
};

// Triangles in planes of one another, through one another's edges and corners, and twice the same.
Scene lattice_soup(Draw& draw, int count) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i)
        triangles.push_back({draw.on_lattice(-2, 2), draw.on_lattice(-2, 2), draw.on_lattice(-2, 2)});
    for (int i = 0; i < count / 3; ++i) {
        const Triangle again = triangles[static_cast<std::size_t>(draw.integer(0, count - 1))];
        triangles.insert(triangles.begin() + draw.integer(0, count), again);
    }
    return scene_of(triangles);
}

// Planes through lines that floats cannot represent: they are cut again and again, near the point where they all
// intersect.
Scene pencil(Draw& draw) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < 25; ++i) triangles.push_back({{-1, 0.1f, 0.3f}, {1.3f, -0.1f, 0.7f}, draw.in_cube(1.5)});
    return scene_of(triangles);
}

std::vector<Seen> scenes() {
    Draw draw(12);
    std::vector<Seen> result;
    const auto add = [&](const std::string& name, Scene scene) { result.push_back({name, std::move(scene)}); };
    add("empty", {});
    add("bumps", {.objects = {object(std::make_shared<const Mesh>(bumpy_sphere(2)))}});
    add("knot", {.objects = {object(std::make_shared<const Mesh>(trefoil_knot(0.4, 4)))}});
    add("soup", scene_of(soup(draw, 120, 2)));
    add("far away", scene_of(soup(draw, 60, 2, Vec3f(3e4f))));
    add("tiny", scene_of(soup(draw, 60, 1e-20f)));
    add("lattice", lattice_soup(draw, 60));
    add("pencil", pencil(draw));
    add("floor", scene_of(floor_of(4)));
    for (Seen& seen : result)
        for (Object& o : seen.scene.objects) o.sides = any_sides(draw);
    return result;
}

Vec3d middle(const Scene& scene) {
    if (scene.objects.empty()) return Vec3d(0);
    return bounds(scene.objects[0].shape)->center();
}

double extent(const Scene& scene) {
    if (scene.objects.empty()) return 1;
    const Box box = *bounds(scene.objects[0].shape);
    return glm::length(convert<double>(box.max) - convert<double>(box.min));
}

CameraFrame from(const Vec3d& eye, const Vec3d& target) {
    return camera_frame({.position = eye, .target = target, .up = {0.01, 1, 0.02}}, {48, 36});
}

std::size_t differing(const PaintedPicture& painted, const Accelerator& list, const CameraFrame& frame) {
    Traversal traversal;
    std::size_t count = 0;
    for (int y = 0; y < painted.height; ++y) {
        for (int x = 0; x < painted.width; ++x) {
            const auto expected = list.closest(eye_ray(frame, x + 0.5, y + 0.5), traversal);
            const auto& given = painted.seen[static_cast<std::size_t>(y * painted.width + x)];
            count += expected.has_value() != given.has_value() ||
                     (expected && (expected->primitive != given->primitive || expected->t != given->t));
        }
    }
    return count;
}

}  // namespace

TEST_CASE("what is painted back to front is what the rays hit: every pixel, ties too") {
    Draw draw(13);
    std::size_t rounded = 0;
    for (const auto& [name, scene] : scenes()) {
        const PaintersTree tree(scene);
        const auto list = make_accelerator("list", scene);
        for (int i = 0; i < 6; ++i) {
            Vec3d eye = middle(scene) + convert<double>(draw.in_cube(1)) * extent(scene);
            if (i == 3) eye = middle(scene) + Vec3d(1, 0.5, 2) * extent(scene);
            if (i > 3 && tree.triangles() > 0)
                // In the plane of some triangle.
                eye = convert<double>(tree.triangle(static_cast<std::uint32_t>(i)).corners.a);
            const auto frame = from(eye, middle(scene) + Vec3d(0.1, 0.2, 0.3) * extent(scene));
            INFO(name << ", view " << i);
            const auto painted = paint(tree, frame);
            if (i < 3) rounded += painted.compared;
            CHECK(differing(painted, *list, frame) == 0);
        }
    }
    CHECK(rounded > 0);  // rounding has moved corners of pieces off planes that they touch
}

TEST_CASE(
    "where triangles cross in the very point that is hit, the lowest is seen, in whatever order they are painted") {
    Draw draw(14);
    for (int i = 0; i < 20; ++i) {
        const Scene scene = lattice_soup(draw, 40);
        const PaintersTree tree(scene);
        const auto list = make_accelerator("list", scene);
        for (int x = -4; x <= 4; ++x) {
            for (int y = -4; y <= 4; ++y) {
                // A picture of one pixel, whose ray goes through points of the lattice, and halfway between.
                const Camera camera{.position = {x / 2.0, y / 2.0, 5}, .target = {x / 2.0, y / 2.0, 0}};
                const auto frame = camera_frame(camera, {1, 1});
                INFO("scene " << i << ", at " << x << " " << y);
                CHECK(differing(paint(tree, frame), *list, frame) == 0);
            }
        }
    }
}

TEST_CASE("three bars that overlap in a ring have no order until they are cut") {
    const auto bar = [](Vec3f a, Vec3f b) { return Triangle{a, b, (a + b) / 2.0f + Vec3f(0.1f, 0.1f, 0)}; };
    const Scene scene =
        scene_of({bar({-1, -1, 0}, {1, -1, 1}), bar({1, -1.2f, 0}, {0, 1, 1}), bar({0.2f, 1, 0}, {-1, -1.2f, 1})});
    const PaintersTree tree(scene);
    CHECK(tree.pieces() > tree.triangles());
}

TEST_CASE("a convex shape is cut nowhere, and all its triangles lie behind one another") {
    const Scene scene{.objects = {object(std::make_shared<const Mesh>(icosphere(1)))}};
    const PaintersTree tree(scene);
    CHECK(tree.pieces() == 80);
    CHECK(tree.depth() == 80);
}

TEST_CASE("the painter refuses what is no triangle at rest, and an orthographic camera") {
    Scene scene{.objects = {object(Sphere{{0, 0, 0}, 1})}};
    scene.source = "ball.toml";
    scene.objects[0].path = "sphere 0";
    CHECK_THROWS_WITH(PaintersTree(scene),
                      "ball.toml: expected triangles that stand where they were made, found sphere 0");
    const Camera camera{.projection = Orthographic{}};
    CHECK_THROWS_WITH(paint(PaintersTree({}), camera_frame(camera, {4, 4})),
                      "the painter: expected a perspective camera, found an orthographic one");
}
