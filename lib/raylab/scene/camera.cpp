#include "raylab/scene/camera.h"

#include "raylab/base/error.h"
#include "raylab/geometry/largest_coordinate.h"
#include "raylab/geometry/scaled_to_largest_one.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace raylab {

namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

// A cross product of two unit vectors shorter than this is only rounding error (a few units in the last place of each
// product) and has no direction of its own.
constexpr double rounding_of_cross = 16 * unit_roundoff<double>;

std::string in_words(const Vec3d& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

// Eye rays are rounded to floats. NaN must fail this comparison, so it is written positively.
bool fits_float(const Vec3d& v) {
    return std::abs(v.x) <= largest_float && std::abs(v.y) <= largest_float && std::abs(v.z) <= largest_float;
}

// Scaled first: the square of a very short vector is zero.
Vec3d unit(const Vec3d& v) { return glm::normalize(scaled_to_largest_one(v)); }

void check_image(ImageSize image, const std::string& source) {
    const auto in_range = [](int side) { return side >= 1 && side <= largest_image_side; };
    if (in_range(image.width) && in_range(image.height)) return;
    throw Error({source}, fmt::format("an image of 1 to {} pixels a side", largest_image_side),
                fmt::format("{} x {}", image.width, image.height));
}

void check_vectors(const Camera& camera, const std::string& source) {
    const auto check = [&](const char* name, const Vec3d& v) {
        if (!fits_float(v)) throw Error({source}, fmt::format("a camera {} that fits floats", name), in_words(v));
    };
    check("position", camera.position);
    check("target", camera.target);
    check("up", camera.up);
    if (camera.position == camera.target)
        throw Error({source}, "a camera position apart from its target", "both at " + in_words(camera.position));
    if (camera.up == Vec3d{0, 0, 0}) throw Error({source}, "a camera up vector that is not zero", "[0, 0, 0]");
}

// Half the picture's height: at distance 1 for a perspective camera, in metres for an orthographic one.
double half_height(const Perspective& perspective, const std::string& source) {
    if (!(perspective.fov_y > 0 && perspective.fov_y < 180))
        throw Error({source}, "fov_y between 0 and 180 degrees, both excluded", fmt::format("{}", perspective.fov_y));
    return std::tan(perspective.fov_y / 2 * std::numbers::pi / 180);
}

double half_height(const Orthographic& orthographic, const std::string& source) {
    if (!(orthographic.height > 0 && orthographic.height <= largest_float))
        throw Error({source}, "an orthographic height above 0 that fits a float",
                    fmt::format("{}", orthographic.height));
    return orthographic.height / 2;
}

// The origins of an orthographic camera's rays lie as far from the eye as the picture's corners.
void check_reach(const CameraFrame& frame, const std::string& source) {
    if (frame.projection == CameraFrame::Projection::perspective) return;
    const double reach = largest_coordinate(frame.eye) + frame.half_width + frame.half_height;
    if (!(reach <= largest_float))
        throw Error({source}, "an orthographic picture whose corners fit floats", fmt::format("a reach of {}", reach));
}

struct Axes {
    Vec3d right, up, forward;
};

Axes axes_of(const Camera& camera, const std::string& source) {
    const Vec3d forward = unit(camera.target - camera.position);
    const Vec3d sideways = cross(forward, unit(camera.up));
    if (glm::length(sideways) <= rounding_of_cross)
        throw Error({source}, "a camera up vector that is not parallel to the view",
                    fmt::format("up {} and view {}", in_words(camera.up), in_words(camera.target - camera.position)));
    const Vec3d right = unit(sideways);
    return {right, unit(cross(right, forward)), forward};
}

}  // namespace

CameraFrame camera_frame(const Camera& camera, ImageSize image, const std::string& source) {
    check_image(image, source);
    check_vectors(camera, source);

    const auto [right, up, forward] = axes_of(camera, source);
    const double height = std::visit([&](const auto& kind) { return half_height(kind, source); }, camera.projection);
    const bool perspective = std::holds_alternative<Perspective>(camera.projection);
    const CameraFrame frame{
        .eye = camera.position,
        .right = right,
        .up = up,
        .forward = forward,
        .half_width = height * image.width / image.height,  // pixels are square
        .half_height = height,
        .projection = perspective ? CameraFrame::Projection::perspective : CameraFrame::Projection::orthographic,
        .image = image};
    check_reach(frame, source);
    return frame;
}

}  // namespace raylab
