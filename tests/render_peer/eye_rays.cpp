#include "catch.h"
#include "povray.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/shading/surface_point.h"

#include <algorithm>

// Compares what eye rays see with a light at the eye, which casts no visible shadow: the camera, every shape and its
// sides, normals, and the checker.

using namespace raylab;

namespace {

Image picture_by_headlight(const Scene& scene) {
    const auto accelerator = make_accelerator("auto", scene);
    return eye_picture(camera_frame(scene.camera, scene.image), {}, [&](const Ray& ray) -> Color {
        Traversal traversal;
        const auto hit = accelerator->closest(ray, traversal);
        if (!hit) return scene.background.color;
        const auto point = surface_point(scene, ray, *hit);
        const auto direction = convert<double>(ray.direction);
        return std::abs(dot(point.normal, direction)) * diffuse_color(scene, point, direction);
    });
}

Scene with_headlight(Scene scene) {
    const bool perspective = std::holds_alternative<Perspective>(scene.camera.projection);
    const Vec3d view = scene.camera.target - scene.camera.position;
    scene.lights = {perspective ? Light{PointLight{scene.camera.position}} : Light{DistantLight{view}}};
    return scene;
}

// The share of pixels whose difference exceeds that of the half floats in POV-Ray's EXR files.
double share_that_differs(const Image& image, const Image& reference) {
    REQUIRE(image.width() == reference.width());
    REQUIRE(image.height() == reference.height());
    constexpr float half_precision = 0x1p-10f;
    const auto far = [](float a, float b) { return std::abs(a - b) > half_precision * std::max(1.f, std::abs(b)); };
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Pixel &a = image.pixels()[i], &b = reference.pixels()[i];
        count += far(a.r, b.r) || far(a.g, b.g) || far(a.b, b.b);
    }
    return static_cast<double>(count) / static_cast<double>(image.pixels().size());
}

void check_same(const Scene& scene) {
    const auto theirs = povray_picture(with_headlight(scene));
    if (!theirs) return;
    const Image ours = picture_by_headlight(scene);
    write_image(ours, std::filesystem::path(RAYLAB_BUILD) / "tests/render_peer/ours.png");
    write_image(*theirs, std::filesystem::path(RAYLAB_BUILD) / "tests/render_peer/theirs.png");
    CHECK(share_that_differs(ours, *theirs) < 0.0005);
}

Scene shapes() { return read_scene(RAYLAB_SOURCE "/tests/render_peer/shapes.toml"); }

}  // namespace

TEST_CASE("POV-Ray sees every shape as we do: where it is, its front and its back, its normal, its checker") {
    check_same(shapes());
}

TEST_CASE("POV-Ray sees the same through an orthographic camera") {
    Scene scene = shapes();
    scene.camera.projection = Orthographic{7};
    check_same(scene);
}
