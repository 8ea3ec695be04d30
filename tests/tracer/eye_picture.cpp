#include "catch.h"

#include "raylab/tracer/picture/eye_picture.h"

using namespace raylab;

namespace {

CameraFrame frame() {
    return camera_frame({.position = {0, 0, 2}, .target = {0, 0, 0}, .projection = Orthographic{2}}, {40, 20});
}

Color left_half(const Ray& ray) { return ray.origin.x < 0 ? Color{1, 0.5, 0} : Color{0, 0, 0}; }

}  // namespace

TEST_CASE("a pixel shows what its rays bring, from the top left") {
    const Image image = eye_picture(frame(), {}, [](const Ray& ray) { return Color(ray.origin); });
    // The picture is 4 by 2 metres, a pixel 0.1.
    CHECK_THAT(image.at(0, 0).r, WithinAbs(-1.95, 1e-6));
    CHECK_THAT(image.at(0, 0).g, WithinAbs(0.95, 1e-6));
    CHECK_THAT(image.at(39, 19).r, WithinAbs(1.95, 1e-6));
    CHECK_THAT(image.at(39, 19).g, WithinAbs(-0.95, 1e-6));
}

TEST_CASE("a pixel is the mean of its samples") {
    const CameraFrame odd =
        camera_frame({.position = {0, 0, 2}, .target = {0, 0, 0}, .projection = Orthographic{2}}, {41, 20});
    // The middle column's centre is x = 0: half of its cells lie left of it.
    const Image image = eye_picture(odd, {.samples = {.per_side = 4}}, left_half);
    CHECK(image.at(20, 3) == Pixel{0.5f, 0.25f, 0});
    CHECK(image.at(19, 3) == Pixel{1, 0.5f, 0});
}

TEST_CASE("a picture is the same bits for any number of threads", "[threads]") {
    const EyePictureOptions one{.samples = {.pattern = SamplePattern::jittered, .per_side = 3}, .threads = 1};
    EyePictureOptions three = one;
    three.threads = 3;
    const auto color = [](const Ray& ray) { return Color(ray.origin); };
    CHECK((eye_picture(frame(), one, color).pixels() == eye_picture(frame(), three, color).pixels()));
}
