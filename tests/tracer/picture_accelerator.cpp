#include "raylab/tracer/picture/picture_accelerator.h"

#include "catch.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/tracer/picture/whitted_picture.h"

using namespace raylab;

namespace {

// A bumpy glass sphere before a mirror, in a coloured room: every kind of ray.
Scene glass_and_mirror() {
    Scene scene{.background = {{0.2, 0.3, 0.5}, {0.1, 0.1, 0.1}}};
    scene.materials = {
        {.name = "glass", .kr = 0.1, .kt = 0.9, .ior = 1.5}, {.name = "mirror", .kr = 0.8}, {.name = "wall"}};
    scene.lights = {{.kind = PointLight{{3, 6, 4}}}};
    scene.objects = {{.shape = std::make_shared<const Mesh>(bumpy_sphere(2)), .front = 0, .back = 0},
                     {.shape = Sphere{{1.5f, 0, -1}, 1}, .front = 1, .back = 1},
                     {.shape = Plane{{0, -1.2f, 0}, {0, 1, 0}}, .front = 2, .back = 2}};
    return scene;
}

bool has_item_buffer(const PictureAccelerator& accelerator) {
    return dynamic_cast<const ItemBuffer*>(&accelerator.finds()) != nullptr;
}

Image picture(const Scene& scene, const EyePictureOptions& options, BufferUse use) {
    const CameraFrame frame = camera_frame(scene.camera, {40, 30});
    const PictureAccelerator accelerator("auto", scene, frame, {}, options.samples, use);
    CHECK(has_item_buffer(accelerator) == (use == BufferUse::always));
    return whitted_picture(scene, accelerator.finds(), frame, {}, options);
}

std::size_t light_buffers(const Scene& scene, ImageSize size, const WhittedOptions& options = {},
                          const std::string& name = "auto", BufferUse use = BufferUse::where_it_pays) {
    return PictureAccelerator(name, scene, camera_frame(scene.camera, size), options, {}, BufferUse::never, use)
        .light_buffers();
}

bool has_item_buffer(const Scene& scene, ImageSize size, const WhittedOptions& options = {},
                     const std::string& name = "auto") {
    return has_item_buffer(PictureAccelerator(name, scene, camera_frame(scene.camera, size), options, {}));
}

}  // namespace

TEST_CASE("a picture is the same bits with an item buffer and without", "[threads]") {
    Scene scene = glass_and_mirror();
    for (const auto& projection :
         {decltype(Camera::projection){Perspective{40}}, decltype(Camera::projection){Orthographic{4}}}) {
        scene.camera.projection = projection;
        for (const PixelSamples& samples :
             {PixelSamples{}, PixelSamples{SamplePattern::corner, 1}, PixelSamples{SamplePattern::jittered, 3}}) {
            const EyePictureOptions options{.samples = samples};
            CHECK((picture(scene, options, BufferUse::always).pixels() ==
                   picture(scene, options, BufferUse::never).pixels()));
        }
    }
}

TEST_CASE("an item buffer is drawn where the eye rays are many, or the only ones, and nobody named a structure") {
    const Scene scene = glass_and_mirror();  // 322 primitives
    CHECK(has_item_buffer(scene, {80, 80}));
    CHECK_FALSE(has_item_buffer(scene, {60, 60}));
    CHECK_FALSE(has_item_buffer(scene, {80, 80}, {}, "bvh"));
    Scene matt = scene;
    for (Material& material : matt.materials) material.kr = material.kt = 0;
    CHECK(has_item_buffer(matt, {30, 30}, {.shadows = WhittedOptions::Shadows::none}));
    matt.objects.erase(matt.objects.begin());
    CHECK_FALSE(has_item_buffer(matt, {40, 40}, {.shadows = WhittedOptions::Shadows::none}));
}

TEST_CASE("a picture is the same bits with light buffers and without", "[threads]") {
    Scene scene = glass_and_mirror();
    scene.lights.push_back({.kind = SpotLight{{0, 3, 1}, {0, 0, 0}}});
    scene.lights.push_back({.kind = DistantLight{{1, -2, -1}}});
    scene.lights.push_back({.kind = PointLight{{1.5, 0, -1}}});  // in the mirror ball
    const CameraFrame frame = camera_frame(scene.camera, {60, 45});
    const auto drawn = [&](BufferUse item_buffer, BufferUse light_buffers) {
        const PictureAccelerator accelerator("auto", scene, frame, {}, {}, item_buffer, light_buffers);
        CHECK(accelerator.light_buffers() == (light_buffers == BufferUse::always ? 3 : 0));
        return counted_whitted_picture(scene, accelerator.finds(), frame);
    };
    const auto with = drawn(BufferUse::never, BufferUse::always), without = drawn(BufferUse::never, BufferUse::never);
    CHECK((with.image.pixels() == without.image.pixels()));
    CHECK(with.rays.shadow.hit == without.rays.shadow.hit);
    CHECK(with.traversal.box_tests < without.traversal.box_tests);
    CHECK((drawn(BufferUse::always, BufferUse::always).image.pixels() == without.image.pixels()));
}

TEST_CASE("light buffers are made where shadow rays are many, and kept where their lists are short") {
    Scene scene = glass_and_mirror();  // 322 primitives
    const PointLight nearby{{1.2f, 2.4f, 1.6f}};
    scene.lights[0].kind = nearby;
    CHECK(light_buffers(scene, {400, 400}) == 1);
    CHECK(light_buffers(scene, {300, 300}) == 0);
    CHECK(light_buffers(scene, {400, 400}, {}, "bvh") == 0);
    CHECK(light_buffers(scene, {400, 400}, {.shadows = WhittedOptions::Shadows::none}, "auto", BufferUse::always) == 0);
    scene.lights[0].kind = PointLight{{3e3, 6e3, 4e3}};  // sees everything through one cell
    CHECK(light_buffers(scene, {400, 400}) == 0);
    CHECK(light_buffers(scene, {400, 400}, {}, "auto", BufferUse::always) == 1);
    scene.lights[0].kind = nearby;
    scene.objects.erase(scene.objects.begin());
    CHECK(light_buffers(scene, {400, 400}) == 0);
}
