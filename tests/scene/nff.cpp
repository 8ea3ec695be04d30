#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/scene/read_scene.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace raylab;

namespace {

Scene every_entity() { return read_scene(RAYLAB_SOURCE "/tests/scene/files/every_entity.nff"); }

template <class T>
const T& shape(const Scene& scene, std::size_t object) {
    return std::get<T>(scene.objects.at(object).shape);
}

const std::string view =
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0.01\nresolution 512 512\nf 1 1 1 1 0 1 0 1\n";

Scene read(const std::string& text) { return read_scene_text(text, "test.nff"); }

std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

// The Standard Procedural Databases, if the machine has them.
std::optional<std::filesystem::path> databases() {
    const char* shared = std::getenv("RAYLAB_SHARED");
    if (!shared) return std::nullopt;
    return std::filesystem::path(shared) / "spd";
}

}  // namespace

TEST_CASE("the view, the background and the lights of an NFF file are read") {
    const auto scene = every_entity();
    CHECK(scene.camera.position == Vec3d{0, -4, 1});
    CHECK(scene.camera.target == Vec3d{0, 0, 0.5});
    CHECK(scene.camera.up == Vec3d{0, 0, 1});
    CHECK(std::get<Perspective>(scene.camera.projection).fov_y == 30);
    CHECK((scene.image.width == 64 && scene.image.height == 48));
    CHECK(scene.background.color == Color{0.25, 0.5, 0.75});
    REQUIRE(scene.lights.size() == 2);
    CHECK(std::get<PointLight>(scene.lights[0].kind).position == Vec3d{4, 3, 2});
    CHECK(scene.lights[1].color == Color{0.5, 0.25, 0.125});
}

TEST_CASE("n lights without a colour have an intensity of 1 / sqrt(n) each") {
    CHECK_THAT(every_entity().lights[0].color.x, WithinRel(1 / std::sqrt(2.0)));
    CHECK(read(view + "l 1 2 3").lights.at(0).color == Color{1, 1, 1});
}

TEST_CASE("a fill becomes Whitted's terms") {
    const auto fill = every_entity().materials.at(0);
    CHECK(std::get<Color>(fill.diffuse) == Color{0.8, 0.4, 0.2});
    CHECK(fill.specular == Color{0.2, 0.2, 0.2});
    CHECK(fill.shininess == 30);
    CHECK(fill.kr == 0.2);
    CHECK(fill.kt == 0);
    CHECK(fill.ior == 1);  // the file has 0, like SPD's opaque fills
    const auto glass = every_entity().materials.at(1);
    CHECK((glass.kr == 0.1 && glass.kt == 0.9 && glass.ior == 1.5));
}

TEST_CASE("a fill that sends on more light than arrives is scaled to send on all of it") {
    const auto fill = every_entity().materials.at(2);
    CHECK_THAT(fill.kr, WithinRel(0.4));
    CHECK_THAT(fill.kt, WithinRel(0.6));
    CHECK(fill.kr + fill.kt <= 1);
    for (const std::string shares : {"0.13 1 0.94", "0.26 1 0.83", "2.871 1 0.006"}) {  // both quotients are rounded up
        const auto rounded = read(view + "f 1 1 1 1 " + shares + " 1\n").materials.back();
        CHECK(rounded.kr + rounded.kt <= 1);
    }
}

TEST_CASE("opaque objects are seen from outside, from inside where radii are negative") {
    const auto scene = every_entity();
    CHECK(shape<Sphere>(scene, 0).radius == 0.5f);
    CHECK(scene.objects[0].sides == Sides::front);
    CHECK(shape<Sphere>(scene, 1).radius == 0.25f);
    CHECK(scene.objects[1].sides == Sides::back);
    CHECK(scene.objects[3].sides == Sides::back);
}

TEST_CASE("a cone whose radii are zero and negative is seen from inside") {
    CHECK(read(view + "c 0 0 0 0 0 0 1 -0.5\n").objects.at(0).sides == Sides::back);
    CHECK(read(view + "c 0 0 0 -0.5 0 0 1 0\n").objects.at(0).sides == Sides::back);
    CHECK(read(view + "c 0 0 0 0 0 0 1 0.5\n").objects.at(0).sides == Sides::front);
}

TEST_CASE("transmitting objects are seen from both sides") { CHECK(every_entity().objects.at(6).sides == Sides::both); }

TEST_CASE("cones and cylinders are open") {
    const auto scene = every_entity();
    const auto& cone = shape<Cone>(scene, 2);
    CHECK((cone.base == Vec3f{0, 0, 0} && cone.top == Vec3f{0, 0, 1}));
    CHECK((cone.base_radius == 0.5f && cone.top_radius == 0.25f && cone.ends == Ends::open));
    CHECK(shape<Cylinder>(scene, 3).radius == 0.5f);
    CHECK(shape<Cylinder>(scene, 3).ends == Ends::open);
}

TEST_CASE("three vertices are a triangle, more a polygon, concave ones too") {
    const auto scene = every_entity();
    CHECK(shape<Triangle>(scene, 4).b == Vec3f{1, 0, 0});
    CHECK(shape<Polygon>(scene, 5).vertices.size() == 5);
}

TEST_CASE("a convex patch is a mesh with its normals") {
    const auto scene = every_entity();
    const auto& mesh = *shape<std::shared_ptr<const Mesh>>(scene, 7);
    CHECK(mesh.faces.size() == 2);
    CHECK(mesh.normals.at(2) == Vec3f{0, 1, 0});
}

TEST_CASE("a patch that its first vertex does not see whole is kept as a polygon") {
    // The last vertex of the first patch below lies beyond the notch; a fan of the same outline is possible from the
    // notch.
    const std::string n = " 0 0 1\n";
    const auto hidden = read(view + "pp 4\n0 2 0" + n + "0 0 0" + n + "2 0 0" + n + "0.5 0.5 0" + n);
    CHECK(std::holds_alternative<Polygon>(hidden.objects.at(0).shape));
    const auto seen = read(view + "pp 4\n0.5 0.5 0" + n + "0 2 0" + n + "0 0 0" + n + "2 0 0" + n);
    CHECK(std::holds_alternative<std::shared_ptr<const Mesh>>(seen.objects.at(0).shape));
}

TEST_CASE("a patch with a vertex on an edge is a mesh all the same") {
    const std::string n = " 0 0 1\n";
    const auto scene = read(view + "pp 4\n0 0 0" + n + "1 0 0" + n + "2 0 0" + n + "0 2 0" + n);
    CHECK(std::holds_alternative<std::shared_ptr<const Mesh>>(scene.objects.at(0).shape));
}

TEST_CASE("words may be spread over lines, or one line hold an object, comments anywhere") {
    CHECK(read(view + "c 0 0 0 1\n# half\n0 0 1\r\n 0.5 s # a sphere\n\t0 0 0 1").objects.size() == 2);
}

TEST_CASE("an NFF error names file and line") {
    CHECK(refusal(view + "s 0 0 0 x") == "test.nff:9: expected the radius of a sphere (a number), found \"x\"");
    CHECK(refusal(view + "q 1") == "test.nff:9: expected an entity (v, b, l, f, c, s, p, pp), found \"q\"");
}

TEST_CASE("numbers do not follow the locale: a comma is no decimal point") {
    CHECK(refusal(view + "s 0 0 0 0,5") != "accepted");
}

TEST_CASE("a number has one sign at most") {
    CHECK(read(view + "s 0 0 0 +5\n").objects.size() == 1);
    for (const std::string number : {"+-5", "++5", "--5", "+"})
        CHECK(refusal(view + "s 0 0 0 " + number + "\n").ends_with("found \"" + number + '"'));
}

TEST_CASE("a polygon may end with its file") {
    CHECK(shape<Triangle>(read(view + "p 3\n0 0 0 1 0 0 0 1 0"), 0).c == Vec3f{0, 1, 0});
}

TEST_CASE("a missing view, a missing fill and a second view are refused") {
    CHECK(refusal("b 0 0 0").find("expected a view (v)") != std::string::npos);
    CHECK(refusal("s 0 0 0 1").find("expected a fill (f) before the first object, found sphere") != std::string::npos);
    CHECK(refusal(view + view).find("expected one view, found a second (first at test.nff:1)") != std::string::npos);
}

TEST_CASE("the Standard Procedural Databases are read whole") {
    const auto folder = databases();
    if (!folder) {
        WARN("skipped: RAYLAB_SHARED names no folder with the databases");
        return;
    }
    CHECK(read_scene(*folder / "balls.nff").objects.size() == 7382);
    CHECK(read_scene(*folder / "mount.nff").objects.size() == 8196);
    CHECK(read_scene(*folder / "rings.nff").objects.size() == 8401);
    CHECK(read_scene(*folder / "tetra.nff").objects.size() == 4096);
    CHECK(read_scene(*folder / "rings.nff").materials.size() == 841);
}
