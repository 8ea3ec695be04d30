#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/scene/camera.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace raylab;
using Catch::Matchers::Contains;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-14;  // of a few operations on numbers near 1

// From above and to the side, so that no axis of the frame is an axis of the world.
const Camera askew{.position = {3, 4, 5}, .target = {-1, 0.5, 1}, .up = {0.1, 1, 0.2}, .projection = Perspective{50}};

double angle_between(const Vec3d& a, const Vec3d& b) {
    return std::atan2(glm::length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

void check_equal(const Vec3d& a, const Vec3d& b) {
    CHECK_THAT(a.x, WithinAbs(b.x, rounding));
    CHECK_THAT(a.y, WithinAbs(b.y, rounding));
    CHECK_THAT(a.z, WithinAbs(b.z, rounding));
}

std::string refusal(const Camera& camera, ImageSize image = {}) {
    try {
        camera_frame(camera, image, "test.toml:7");
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

Camera with_position(Vec3d position) { return {.position = position}; }
Camera with_up(Vec3d up) { return {.up = up}; }
Camera with_fov(double fov_y) { return {.projection = Perspective{fov_y}}; }
Camera with_height(double height) { return {.projection = Orthographic{height}}; }

}  // namespace

TEST_CASE("a camera's frame is orthonormal and right-handed") {
    const auto frame = camera_frame(askew, {640, 480});
    CHECK_THAT(glm::length(frame.right), WithinAbs(1, rounding));
    CHECK_THAT(glm::length(frame.up), WithinAbs(1, rounding));
    CHECK_THAT(glm::length(frame.forward), WithinAbs(1, rounding));
    check_equal(cross(frame.forward, frame.right), -frame.up);
    check_equal(cross(frame.right, frame.up), -frame.forward);
}

TEST_CASE("the up vector points to the top of the picture") {
    const auto frame = camera_frame(askew, {640, 480});
    CHECK(dot(frame.up, askew.up) > 0);
    CHECK_THAT(dot(frame.right, askew.up), WithinAbs(0, rounding));
}

TEST_CASE("the ray through the middle of the picture goes from the eye to the target") {
    const auto ray = picture_ray(camera_frame(askew, {640, 480}), 320, 240);
    check_equal(ray.origin, askew.position);
    check_equal(ray.direction, glm::normalize(askew.target - askew.position));
}

TEST_CASE("fov_y is the angle between the top and the bottom edge of the picture") {
    const auto frame = camera_frame(askew, {640, 480});
    CHECK_THAT(angle_between(picture_ray(frame, 320, 0).direction, picture_ray(frame, 320, 480).direction),
               WithinAbs(50, 1e-12));
}

TEST_CASE("pixels are square: a picture twice as wide sees twice the tangent") {
    const auto frame = camera_frame(with_fov(90), {200, 100});
    const auto left = picture_ray(frame, 0, 50).direction;
    CHECK_THAT(left.x / -left.z, WithinAbs(-2, rounding));
}

TEST_CASE("x runs to the right and y downward") {
    const auto frame = camera_frame({}, {640, 480});
    CHECK(picture_ray(frame, 640, 240).direction.x > 0);
    CHECK(picture_ray(frame, 320, 480).direction.y < 0);
}

TEST_CASE("perspective rays have unit directions, at the corners too") {
    const auto frame = camera_frame(askew, {640, 480});
    for (const double x : {0.0, 0.5, 640.0})
        CHECK_THAT(glm::length(picture_ray(frame, x, 480).direction), WithinAbs(1, rounding));
}

TEST_CASE("orthographic rays are parallel and start on a rectangle of the given height through the eye") {
    Camera camera = askew;
    camera.projection = Orthographic{3};
    const auto frame = camera_frame(camera, {640, 480});
    const auto top_left = picture_ray(frame, 0, 0);
    const auto bottom_left = picture_ray(frame, 0, 480);
    const auto bottom_right = picture_ray(frame, 640, 480);
    CHECK(top_left.direction == bottom_right.direction);
    check_equal(top_left.direction, frame.forward);
    CHECK_THAT(glm::length(top_left.origin - bottom_left.origin), WithinAbs(3, rounding));
    CHECK_THAT(glm::length(bottom_right.origin - bottom_left.origin), WithinAbs(4, rounding));
    check_equal((top_left.origin + bottom_right.origin) / 2.0, camera.position);
}

TEST_CASE("an eye ray is the picture ray rounded to floats, from 0 to infinity, leaving no surface") {
    const auto frame = camera_frame(askew, {640, 480});
    const auto exact = picture_ray(frame, 17.25, 99.5);
    const auto ray = eye_ray(frame, 17.25, 99.5);
    CHECK(ray.origin == convert<float>(exact.origin));
    CHECK(ray.direction == convert<float>(exact.direction));
    CHECK(ray.range.min == 0);
    CHECK(ray.range.max == std::numeric_limits<float>::infinity());
    CHECK(ray.leaving == no_primitive);
}

TEST_CASE("the length of up and the distance of the target do not matter, however extreme") {
    const auto frame = camera_frame({.position = {0, 0, 0}, .target = {0, 0, -1e-200}, .up = {1e-250, 1e-250, 0}}, {});
    check_equal(frame.forward, {0, 0, -1});
    check_equal(frame.up, Vec3d{1, 1, 0} / std::numbers::sqrt2);
    check_equal(camera_frame({.position = {0, 0, 3e38}, .up = {0, 3e38, 0}}, {}).forward, {0, 0, -1});
}

TEST_CASE("a field of view as wide as a double below 180 still looks forward") {
    const auto frame = camera_frame(with_fov(std::nextafter(180, 0)), {});
    CHECK(frame.half_height > 1e15);
}

TEST_CASE("a degenerate camera is refused with its source, what was expected and what was found") {
    CHECK_THAT(refusal(with_position({0, 0, 0})),
               Contains("test.toml:7: expected a camera position apart from its target"));
    CHECK_THAT(refusal(with_position({0, not_a_number, 0})),
               Contains("camera position that fits floats, found [0, nan, 0]"));
    CHECK_THAT(refusal(with_position({0, 0, 1e39})), Contains("camera position that fits floats"));
    CHECK_THAT(refusal({.target = {infinity, 0, 0}}), Contains("camera target that fits floats"));
    CHECK_THAT(refusal(with_up({0, not_a_number, 0})), Contains("camera up that fits floats"));
    CHECK_THAT(refusal(with_up({0, 0, 0})), Contains("up vector that is not zero"));
    CHECK_THAT(refusal(with_up({0, 0, -3})), Contains("not parallel to the view"));
}

TEST_CASE("an up vector that is parallel to the view but for rounding is refused") {
    const Vec3d view{0.1, 0.2, 0.3};
    const Vec3d up = view * 3.0;
    REQUIRE(cross(view, up) != Vec3d{0, 0, 0});
    CHECK_THAT(refusal({.position = {0, 0, 0}, .target = view, .up = up}), Contains("not parallel to the view"));
    CHECK(refusal({.position = {0, 0, 0}, .target = view, .up = up + Vec3d{1e-12, 0, 0}}) == "accepted");
}

TEST_CASE("a field of view outside (0, 180) is refused") {
    for (const double fov_y : {0.0, -40.0, 180.0, 360.0, not_a_number, infinity})
        CHECK_THAT(refusal(with_fov(fov_y)), Contains("fov_y between 0 and 180 degrees"));
}

TEST_CASE("an orthographic height that is no size is refused") {
    for (const double height : {0.0, -2.0, not_a_number, infinity, 1e39})
        CHECK_THAT(refusal(with_height(height)), Contains("orthographic height above 0"));
    CHECK_THAT(refusal(with_height(3e38), {1000, 1}), Contains("corners fit floats"));
}

TEST_CASE("an image size out of range is refused") {
    for (const ImageSize size : {ImageSize{0, 480}, {640, 0}, {-1, 480}, {640, 16385}, {2147483647, 1}})
        CHECK_THAT(refusal({}, size), Contains("an image of 1 to 16384 pixels a side"));
    CHECK(refusal({}, {16384, 1}) == "accepted");
}
