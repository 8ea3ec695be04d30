#include "catch.h"

#include "raylab/geometry/placement_at.h"
#include "raylab/scene/read_scene.h"

#include <string>
#include <vector>

using namespace raylab;

namespace {

const std::string every_key_file = RAYLAB_SOURCE "/tests/scene/files/every_key.toml";

Scene every_key() { return read_scene(every_key_file); }

template <class T>
const T& shape(const Scene& scene, const std::string& path) {
    for (const auto& object : scene.objects)
        if (object.path == path) return std::get<T>(object.shape);
    FAIL("no object " << path);
    throw std::logic_error("unreachable");
}

const Object& object(const Scene& scene, const std::string& path) {
    for (const auto& each : scene.objects)
        if (each.path == path) return each;
    FAIL("no object " << path);
    throw std::logic_error("unreachable");
}

const Material& material(const Scene& scene, const std::string& name) {
    for (const auto& each : scene.materials)
        if (each.name == name) return each;
    FAIL("no material " << name);
    throw std::logic_error("unreachable");
}

}  // namespace

TEST_CASE("image, camera and background are what the file says") {
    const auto scene = every_key();
    CHECK(scene.source == every_key_file);
    CHECK(scene.model == RenderModel::path);
    CHECK(scene.image.width == 320);
    CHECK(scene.image.height == 200);
    CHECK(scene.camera.position == Vec3d{0, 1.5, 6});
    CHECK(scene.camera.target == Vec3d{0, 1, 0.25});
    CHECK(scene.camera.up == Vec3d{0.5, 1, 0});
    CHECK(std::get<Perspective>(scene.camera.projection).fov_y == 35.5);
    CHECK(scene.camera.lens.value().radius == 0.05);
    CHECK(scene.camera.lens.value().focus == 6);
    CHECK(scene.camera.shutter.value().open == 0.25);
    CHECK(scene.camera.shutter.value().close == 0.5);
    CHECK(scene.background.color == Color{0.2, 0.3, 0.5});
    CHECK(scene.background.ambient == Color{0.1, 0.2, 0.3});
    CHECK(scene.background.zenith == Color{0.05, 0.15, 0.4});
}

TEST_CASE("materials are what the file says, those of included files first") {
    const auto scene = every_key();
    CHECK(scene.materials.at(0).name == "gold");
    const auto& glass = material(scene, "glass");
    CHECK(glass.ambient == Color{0.01, 0.02, 0.03});
    CHECK(std::get<Color>(glass.diffuse) == Color{0.05, 0.06, 0.07});
    CHECK(glass.specular == Color{0.6, 0.7, 0.8});
    CHECK(glass.shininess == 80);
    CHECK(glass.kr == 0.1);
    CHECK(glass.kt == 0.9);
    CHECK(glass.ior == 1.5);
    CHECK(glass.priority == 2);
    CHECK(glass.emission == Color{4, 5, 6});
    CHECK(std::get<Gloss>(material(scene, "satin").polish).exponent == 40);
    CHECK(std::get<Roughness>(material(scene, "frosted").polish).value == 0.25);
    const auto checker = std::get<Checker>(material(scene, "floor").diffuse);
    CHECK(checker.a == Color{0.9, 0.8, 0.7});
    CHECK(checker.b == Color{0.1, 0.2, 0.3});
    CHECK(checker.size == 0.5);
}

TEST_CASE("lights are what the file says") {
    const auto scene = every_key();
    REQUIRE(scene.lights.size() == 3);
    CHECK(std::get<PointLight>(scene.lights[0].kind).position == Vec3d{3, 6, 4});
    CHECK(scene.lights[0].color == Color{1, 2, 3});
    CHECK(scene.lights[0].attenuation == Vec3d{0.5, 0.25, 0.125});
    const auto spot = std::get<SpotLight>(scene.lights[1].kind);
    CHECK(spot.position == Vec3d{1, 2, 3});
    CHECK(spot.target == Vec3d{0, 1, 0});
    CHECK(spot.cone == 12.5);
    CHECK(spot.exponent == 7);
    CHECK(scene.lights[1].color == Color{3, 2, 1});
    CHECK(scene.lights[1].attenuation == Vec3d{1, 2, 4});
    CHECK(std::get<DistantLight>(scene.lights[2].kind).direction == Vec3d{1, -1, 0.5});
    CHECK(scene.lights[2].color == Color{0.5, 0.5, 0.25});
}

TEST_CASE("round shapes are what the file says") {
    const auto scene = every_key();
    CHECK(shape<Sphere>(scene, "sphere 0").center == Vec3f{-5, 0, 0});
    CHECK(shape<Sphere>(scene, "sphere 1").center == Vec3f{0, 1, 2});
    CHECK(shape<Sphere>(scene, "sphere 1").radius == 1.25f);
    CHECK(shape<Ellipsoid>(scene, "ellipsoid 0").center == Vec3f{3, 4, 5});
    CHECK(shape<Ellipsoid>(scene, "ellipsoid 0").radii == Vec3f{1, 2, 3});
    const auto& cylinder = shape<Cylinder>(scene, "cylinder 0");
    CHECK((cylinder.base == Vec3f{0, 0, 1} && cylinder.top == Vec3f{0, 2, 1}));
    CHECK((cylinder.radius == 0.5f && cylinder.ends == Ends::capped));
    const auto& cone = shape<Cone>(scene, "cone 0");
    CHECK((cone.base == Vec3f{1, 0, 0} && cone.top == Vec3f{1, 2, 0}));
    CHECK((cone.base_radius == 0.75f && cone.top_radius == 0.25f && cone.ends == Ends::capped));
    const auto& paraboloid = shape<Paraboloid>(scene, "paraboloid 0");
    CHECK((paraboloid.base == Vec3f{2, 0, 0} && paraboloid.top == Vec3f{2, 2, 0}));
    CHECK((paraboloid.radius == 0.5f && paraboloid.ends == Ends::capped));
    const auto& hyperboloid = shape<Hyperboloid>(scene, "hyperboloid 0");
    CHECK((hyperboloid.base == Vec3f{3, 0, 0} && hyperboloid.top == Vec3f{3, 2, 0}));
    CHECK((hyperboloid.waist == 0.25f && hyperboloid.radius == 0.5f && hyperboloid.ends == Ends::capped));
}

TEST_CASE("flat shapes are what the file says") {
    const auto scene = every_key();
    CHECK(shape<Plane>(scene, "plane 0").point == Vec3f{0, -1, 0});
    CHECK(shape<Plane>(scene, "plane 0").normal == Vec3f{0, 2, 0});
    CHECK(shape<Disk>(scene, "disk 0").center == Vec3f{0, 3, 0});
    CHECK(shape<Disk>(scene, "disk 0").normal == Vec3f{0, 0, 1});
    CHECK(shape<Disk>(scene, "disk 0").radius == 0.5f);
    const auto& annulus = shape<Annulus>(scene, "annulus 0");
    CHECK((annulus.center == Vec3f{0, 4, 0} && annulus.normal == Vec3f{0, 0, 1}));
    CHECK((annulus.inner_radius == 0.25f && annulus.outer_radius == 0.75f));
    CHECK(shape<Polygon>(scene, "polygon 0").vertices.size() == 4);
    CHECK(shape<Polygon>(scene, "polygon 0").vertices[2] == Vec3f{1, 1, 0});
    CHECK(shape<Triangle>(scene, "triangle 0").c == Vec3f{0, 2, 0});
    CHECK(shape<std::shared_ptr<const Mesh>>(scene, "mesh 0")->faces.size() == 4);
    CHECK(object(scene, "mesh 0").shading == Shading::gouraud);
}

TEST_CASE("an object has its materials, sides and motion") {
    const auto scene = every_key();
    const auto name = [&](std::size_t index) { return scene.materials.at(index).name; };
    CHECK(name(object(scene, "sphere 1").front) == "glass");
    CHECK(name(object(scene, "sphere 1").back) == "glass");
    CHECK(object(scene, "sphere 1").sides == Sides::front);
    CHECK(object(scene, "sphere 1").motion == Motion{.translation = {1, 2, 3}});
    CHECK(name(object(scene, "ellipsoid 0").front) == "glass");
    CHECK(name(object(scene, "ellipsoid 0").back) == "floor");
    CHECK(object(scene, "ellipsoid 0").sides == Sides::back);
    CHECK(name(object(scene, "cone 0").front) == "plain grey");
    CHECK(object(scene, "cone 0").sides == Sides::both);
    CHECK_FALSE(object(scene, "cone 0").motion.has_value());
    CHECK(object(scene, "cone 0").placement.is_identity());
}

TEST_CASE("the steps of a transform are applied in order") {
    const auto scene = every_key();
    // (1, 1, 1) is translated to (2, 3, 4), doubled to (4, 6, 8), scaled to (4, 12, 32), rotated to (-4, -12, 32),
    // sheared and translated.
    const auto image = transform_point(object(scene, "sphere 1").placement, {1, 1, 1});
    CHECK_THAT(image.x, WithinAbs(-4 + 0.5 * -12 + 10, 1e-5));
    CHECK_THAT(image.y, WithinAbs(-12 + 20, 1e-5));
    CHECK_THAT(image.z, WithinAbs(32 + 30, 1e-5));
}

TEST_CASE("groups in groups are flattened, their transforms and motions composed") {
    const auto scene = every_key();
    const auto& own = object(scene, "pair[0]/sphere 0");
    CHECK(transform_point(own.placement, {0, 0, 0}) == Vec3d{0, 2, 0});
    CHECK(own.motion == Motion{.translation = {1, 0, 1}});
    const auto& inner = object(scene, "pair[0]/dot[0]/sphere 1");
    CHECK(transform_point(inner.placement, {2, 2, 2}) == Vec3d{4, 6, 4});
    CHECK(inner.motion == Motion{.translation = {0, 1, 1}});
    CHECK(scene.materials.at(inner.front).name == "gold");
}

// The shutter closes at half a second.
TEST_CASE("a transform_end is where things are when the shutter closes, motions and groups included") {
    const auto scene = every_key();
    const auto& triangle = object(scene, "triangle 0");
    CHECK(triangle.placement.is_identity());
    CHECK(triangle.motion == Motion{{Vec3f{2, 0, 0}, Vec3f{0, 2, 0}, Vec3f{0, 0, 2}}, {0, 0, 4}});
    const auto at_the_end = [&](const char* path, const Vec3d& p) {
        const Object& each = object(scene, path);
        return transform_point(rounded_placement(each.placement, each.motion.value(), 0.5f), p);
    };
    CHECK(at_the_end("pair[1]/sphere 0", {0, 0, 0}) == Vec3d{1, 0, 0});         // 2 (0 + 1 / 2)
    CHECK(at_the_end("pair[1]/dot[0]/sphere 1", {2, 2, 2}) == Vec3d{8, 9, 8});  // 2 (2 (2, 2, 2) + (0, 1, 0) / 2)
}

TEST_CASE("objects stand in the order of the file, instances where they stand, included files first") {
    std::vector<std::string> paths;
    const auto scene = every_key();
    for (const auto& each : scene.objects) paths.push_back(each.path);
    CHECK(paths == std::vector<std::string>{"sphere 0", "sphere 1", "ellipsoid 0", "cylinder 0", "cone 0",
                                            "paraboloid 0", "hyperboloid 0", "plane 0", "disk 0", "annulus 0",
                                            "polygon 0", "pair[0]/sphere 0", "pair[0]/dot[0]/sphere 0",
                                            "pair[0]/dot[0]/sphere 1", "triangle 0", "mesh 0", "pair[1]/sphere 0",
                                            "pair[1]/dot[0]/sphere 0", "pair[1]/dot[0]/sphere 1"});
}

TEST_CASE("an orthographic camera has a height") {
    const auto scene = read_scene_text("raylab = 1\ncamera = { type = \"orthographic\", height = 3.5 }", "a.toml");
    CHECK(std::get<Orthographic>(scene.camera.projection).height == 3.5);
}
