#include "catch.h"

#include "raylab/sampling/sequence.h"
#include "raylab/scene/picture_point.h"

using namespace raylab;

namespace {

CameraFrame frame_of(std::variant<Perspective, Orthographic> projection) {
    return camera_frame({.position = {1, 2, 7}, .target = {0.5, 1, 0}, .up = {0.1, 1, 0}, .projection = projection},
                        {320, 200});
}

}  // namespace

TEST_CASE("a point on a pixel's ray appears where the ray left the picture") {
    for (const CameraFrame& frame : {frame_of(Perspective{50}), frame_of(Orthographic{3})}) {
        RandomSequence random(5, 0);
        for (int i = 0; i < 1000; ++i) {
            const double x = random.between(-50, 370), y = random.between(-50, 250), t = random.between(0.01, 100);
            const auto ray = picture_ray(frame, x, y);
            const auto back = picture_point(frame, ray.origin + t * ray.direction);
            REQUIRE(back);
            CHECK_THAT(back->x, WithinAbs(x, 1e-9));
            CHECK_THAT(back->y, WithinAbs(y, 1e-9));
        }
    }
}

TEST_CASE("what lies behind the eye or beside it has no place in the picture") {
    const CameraFrame frame = frame_of(Perspective{50});
    CHECK_FALSE(picture_point(frame, frame.eye - frame.forward));
    CHECK_FALSE(picture_point(frame, frame.eye));
    CHECK(picture_point(frame, frame.eye + 1e-9 * frame.forward));
}
