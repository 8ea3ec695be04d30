#include "catch.h"

#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/first_hit_picture.h"
#include "raylab/tracer/shading/surface_point.h"

using namespace raylab;

namespace {

// A unit sphere in front of a wall, seen along -z.
const std::string scene_text = R"(
raylab = 1
[image]
width = 40
height = 30
[camera]
type = "orthographic"
position = [0, 0, 5]
target = [0, 0, 0]
height = 6
[background]
color = [0.1, 0.2, 0.9]
[material.red]
diffuse = [0.8, 0.1, 0.1]
[material.blue]
diffuse = [0.1, 0.1, 0.8]
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "red"
[[shape]]
type = "triangle"
vertices = [[0, -3, -2], [40, -3, -2], [0, 37, -2]]
material = { front = "blue", back = "red" }
)";

struct Setting {
    Scene scene = read_scene_text(scene_text, "test.toml");
    std::unique_ptr<Accelerator> list = make_accelerator("list", scene);
    CameraFrame frame = camera_frame(scene.camera, scene.image);
};

}  // namespace

TEST_CASE("each eye ray shows the first surface it hits, or the background", "[threads]") {
    const Setting s;
    const Image image = first_hit_picture(s.scene, *s.list, s.frame);
    CHECK(image.at(20, 15).r > image.at(20, 15).b);               // the sphere hides the wall
    CHECK(image.at(35, 15).b > image.at(35, 15).r);               // the wall, right of the sphere
    CHECK(image.at(2, 2) == to_pixel(s.scene.background.color));  // nothing
}

TEST_CASE("a surface that faces the light has its full colour, one turned away keeps a shade of it") {
    const Setting s;
    const Ray ray = eye_ray(s.frame, 35, 15);
    const Color full = first_hit_color(s.scene, *s.list, ray, FirstHitShading::light, {0, 0, 2});
    CHECK_THAT(full.z, WithinRel(0.8, 1e-6));
    const Color away = first_hit_color(s.scene, *s.list, ray, FirstHitShading::light, {0, 0, -1});
    CHECK(away.z > 0);
    CHECK(away.z < 0.25 * full.z);
}

TEST_CASE("a normal shown as a colour points at the viewer from either side") {
    const Setting s;
    const Ray front = eye_ray(s.frame, 35, 15);
    const Color there = first_hit_color(s.scene, *s.list, front, FirstHitShading::normals, {0, 0, 1});
    CHECK_THAT(there.z, WithinAbs(1, 1e-9));
    const Ray behind{.origin = {2, 0, -5}, .direction = {0, 0, 1}};
    const Color back = first_hit_color(s.scene, *s.list, behind, FirstHitShading::normals, {0, 0, 1});
    CHECK_THAT(back.z, WithinAbs(0, 1e-9));
}

TEST_CASE("each side of a surface has its own material") {
    const Setting s;
    Traversal traversal;
    for (const float side : {5.0f, -5.0f}) {
        const Ray ray{.origin = {2, 0, side}, .direction = {0, 0, -side}};
        const auto hit = s.list->closest(ray, traversal);
        REQUIRE(hit);
        const SurfacePoint point = surface_point(s.scene, ray, *hit);
        CHECK_THAT(point.position.z, WithinAbs(-2, 1e-6));
        const Color color = diffuse_color(s.scene, point, convert<double>(ray.direction));
        CHECK((color.z > color.x) == (side > 0));
    }
}
