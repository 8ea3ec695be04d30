#include "raylab/tracer/media/eye_media.h"

#include "scenes.h"

#include "catch.h"

#include <algorithm>
#include <memory>
#include <numbers>

using namespace raylab;
using namespace raylab::test;

TEST_CASE("a glass pane that stands in the way out has no inside for the eye to be in") {
    const Stage stage(glass + R"(
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "glass"
[[shape]]
type = "disk"
center = [0, 0, 3]
normal = [0, 0, 1]
radius = 9
material = "glass"
[[shape]]
type = "plane"
point = [4, 0, 0]
normal = [1, 0, 0]
material = "glass"
)");
    const Media around = media_at(stage.scene, *stage.accelerator, {0, 0, 0});
    CHECK(around.current(stage.scene) == &stage.scene.objects[0]);
    CHECK(around.left(&stage.scene.objects[0]).is_empty());
}

TEST_CASE("light that a mesh reflects back inside is still in its glass where it hits a ball in there") {
    Stage stage(glass + R"(
[material.dense]
diffuse = [0, 0, 0]
kt = 1
ior = 2
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "glass"
[[shape]]
type = "sphere"
center = [4, -3, 0]
radius = 1
material = "dense"
)");
    auto roof = std::make_shared<Mesh>();  // an eye below it is in glass, which only a ray that leaves it finds out
    roof->vertices = {{-9, 1, -9}, {0, 1, 9}, {9, 1, -9}};
    roof->faces = {{0, 1, 2}};
    stage.scene.objects[0].shape = std::shared_ptr<const Mesh>(roof);
    stage.accelerator = make_accelerator("list", stage.scene);
    // Reflected whole at [0.35, 1, 0], past the ball's centre at a quarter of its radius.
    const auto tree = stage.tree({0.25 * std::numbers::sqrt2 - 1, 0, 0}, {1, 1, 0},
                                 {.depth = 4, .reflectance = WhittedOptions::Reflectance::fresnel});
    const auto into_ball = std::ranges::find_if(tree.nodes, [](const RayNode& node) {
        return node.kind == RayKind::transmitted && was_cast(node) && node.depth == 3;
    });
    REQUIRE(into_ball != tree.nodes.end());
    const Vec3d o = convert<double>(into_ball->ray.origin) - Vec3d{4, -3, 0},
                d = convert<double>(into_ball->ray.direction);
    CHECK_THAT(2 * glm::length(cross(o, d)), WithinAbs(1.5 * 0.25, 1e-6));  // n r sin(angle) stays
}

TEST_CASE("an eye is in a ball of glass while that passes over it, and in none before and after") {
    const Stage stage(glass + R"(
[camera]
position = [0, 0, 0]
target = [0, 0, -1]
shutter = [-1, 1]
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 1
motion = [3, 0, 0]
material = "glass"
)");
    const EyeMedia eye_media(stage.scene, *stage.accelerator, camera_frame(stage.scene.camera, stage.scene.image));
    for (const float time : {-1.0f, -0.5f, -0.3f, 0.0f, 0.3f, 0.5f, 1.0f}) {
        INFO("at time " << time);
        const Ray ray{.origin = {0, 0, 0}, .direction = {0, 0, -1}, .time = time};
        const bool is_in_glass = eye_media.around(ray, [&](const Media& media) { return !media.is_empty(); });
        CHECK(is_in_glass == (std::abs(time) < 1.0f / 3));
    }
}
