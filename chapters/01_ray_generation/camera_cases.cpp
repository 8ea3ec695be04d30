#include "case_rows.h"
#include "cases.h"
#include "textbook_camera.h"

#include "raylab/base/error.h"
#include "raylab/scene/camera.h"

#include <limits>
#include <optional>

namespace raylab::ray_generation {

namespace {

constexpr ImageSize square{200, 200};

std::optional<std::string> refusal(const Camera& camera) {
    try {
        camera_frame(camera, square);
        return std::nullopt;
    } catch (const Error& error) {
        return error.what();
    }
}

CaseRow refused(const std::string& what, const Camera& camera) {
    const auto words = refusal(camera);
    return {what, "holds: an error that says so", words.value_or("a frame"), words.has_value()};
}

// ---- UP-PARALLEL

Camera leaning(double radians) {  // `up` leans away from the view by this angle
    return {.position = {0, 0, 0}, .target = {0, 0, -1}, .up = {0, std::sin(radians), -std::cos(radians)}};
}

std::vector<CaseRow> up_parallel() {
    std::vector<CaseRow> rows{
        refused("camera_frame, up along the view", leaning(0)),
        refused("camera_frame, up against the view", {.position = {0, 0, 0}, .target = {0, 0, -1}, .up = {0, 0, 3}}),
        refused("camera_frame, no up at all", {.position = {0, 0, 0}, .target = {0, 0, -1}, .up = {0, 0, 0}})};
    // The points are off the axes, so that rounding errors do not cancel by luck.
    const Vec3d target{0.3, -0.7, -1.1}, aside{0.8, 0.5, -0.1};
    for (const double angle : {1e-6, 1e-8}) {
        const Vec3d up = glm::normalize(target) + angle * glm::normalize(cross(target, aside));
        const auto at = fmt::format(", up {:g} from the view", angle);
        rows.push_back(holds("camera_frame, double" + at, "",
                             unsquareness(camera_frame({.position = {0, 0, 0}, .target = target, .up = up}, square)),
                             1e-7));
        rows.push_back(
            fails("textbook, float" + at, "", unsquareness(TextbookCamera<float>({0, 0, 0}, target, up, 40)), 1e-4));
    }
    return rows;
}

// ---- FOV-LIMITS

Camera with_fov(double degrees) {
    return {.position = {0, 0, 1}, .target = {0, 0, 0}, .projection = Perspective{degrees}};
}

// The angle between the ray through the middle of the picture's top edge and the view, in degrees; it should be fov
// / 2.
template <class Vector>
double half_angle(const Vector& top) {
    const Vec3d direction = convert<double>(top);
    return std::atan2(std::hypot(direction.x, direction.y), -direction.z) * 180 / std::numbers::pi;
}

std::vector<CaseRow> fov_limits() {
    std::vector<CaseRow> rows;
    for (const double fov : {0.0, 180.0, -40.0, 360.0, std::numeric_limits<double>::quiet_NaN()})
        rows.push_back(refused(fmt::format("camera_frame, fov_y = {}", fov), with_fov(fov)));
    for (const double fov : {1e-5, 179.9999}) {
        const double open = std::min(fov, 180 - fov);  // the part of the angle that is left
        const auto off = [&](double angle) { return std::abs(angle - fov / 2) / open; };
        const auto at = fmt::format(", fov_y = {}", fov);
        const Vec3d lab = picture_ray(camera_frame(with_fov(fov), square), 100, 0).direction;
        const auto weak = TextbookCamera<float>({0, 0, 1}, {0, 0, 0}, {0, 1, 0}, fov).direction(0, 1);
        rows.push_back(holds("camera_frame, double" + at, " of the opening", off(half_angle(lab)), 1e-9));
        if (fov > 90) rows.push_back(fails("textbook, float" + at, " of the opening", off(half_angle(weak)), 1e-2));
    }
    return rows;
}

// ---- EYE-AT-TARGET

std::vector<CaseRow> eye_at_target() {
    const Vec3d eye{1, 2, 3};
    std::vector<CaseRow> rows{refused("camera_frame, eye at the target", {.position = eye, .target = eye})};
    const Vec3d near{0, 3e-30, -4e-30};
    const auto lab = camera_frame({.position = {0, 0, 0}, .target = near, .up = {1, 0, 0}}, square);
    rows.push_back(
        holds("camera_frame, target 5e-30 m away", "", glm::length(lab.forward - Vec3d(0, 0.6, -0.8)), 1e-15));
    const TextbookCamera<float> weak({0, 0, 0}, near, {1, 0, 0}, 40);
    rows.push_back(fails("textbook, float, target 5e-30 m away", "",
                         glm::length(convert<double>(weak.forward) - Vec3d(0, 0.6, -0.8)), 1e-3));
    return rows;
}

// ---- CAMERA-SCALE

std::vector<CaseRow> camera_scale() {
    const Vec3d position{1, 2, 5}, target{0.25, 0.5, -1}, up{0.125, 1, 0};
    const auto frame_at = [&](double scale) {
        return camera_frame({.position = scale * position, .target = scale * target, .up = scale * up}, square);
    };
    const auto same_frame = [&](double scale) {
        const CameraFrame a = frame_at(1), b = frame_at(scale);
        return a.right == b.right && a.up == b.up && a.forward == b.forward && b.eye == scale * a.eye;
    };
    std::vector<CaseRow> rows;
    for (const int power : {-100, 100}) {
        const double scale = std::ldexp(1.0, power);
        const bool same = same_frame(scale);
        rows.push_back({fmt::format("camera_frame, everything x 2^{}", power), "holds: the same bits",
                        same ? "the same bits" : "other bits", same});
        const TextbookCamera<float> weak(scale * position, scale * target, scale * up, 40);
        rows.push_back(fails(fmt::format("textbook, float, everything x 2^{}", power), "", unsquareness(weak), 1e-3));
    }
    return rows;
}

// ---- FAR-CAMERA

// How far the ray through a pixel passes from the point it should show, in pixels, for a camera and a target 5 m apart,
// `distance` from the origin.
template <class Origin, class Direction>
double pixels_off(const Vec3d& true_origin, const Vec3d& true_direction, const Origin& origin,
                  const Direction& direction) {
    const Vec3d object = true_origin + 5.0 * true_direction;
    const Vec3d to_object = object - convert<double>(origin), d = convert<double>(direction);
    const double pixel = 2 * std::tan(20 * std::numbers::pi / 180) / square.height;  // in radians, near the middle
    return std::atan2(glm::length(cross(d, to_object)), dot(d, to_object)) / pixel;
}

std::vector<CaseRow> far_camera() {
    std::vector<CaseRow> rows;
    const Vec3d eye{0.3, 0.7, 5.1}, target{0.1, 0.2, 0.15};
    for (const double distance : {1e3, 1e7}) {
        const Vec3d offset{distance, -distance, distance}, far_eye = eye + offset;
        // The truth is the frame near the origin, where nothing is lost, translated to the distance.
        const auto near_ray = picture_ray(camera_frame({.position = eye, .target = target}, square), 30, 60);
        const CameraFrame frame = camera_frame({.position = far_eye, .target = target + offset}, square);
        const auto ray = picture_ray(frame, 30, 60);
        const Ray at_seam = eye_ray(frame, 30, 60);
        const TextbookCamera<float> weak(far_eye, target + offset, {0, 1, 0}, 40);
        const auto off = [&](const auto& origin, const auto& direction) {
            return pixels_off(far_eye, near_ray.direction, origin, direction);
        };
        const auto at = fmt::format(", {:g} m away", distance);
        rows.push_back(holds("frame and ray in double" + at, " px", off(ray.origin, ray.direction), 1e-3));
        const double weak_off = off(weak.eye, weak.direction(-0.7f, 0.4f)),
                     seam_off = off(at_seam.origin, at_seam.direction);
        if (distance < 1e5) {
            rows.push_back(holds("frame in double, ray in float" + at, " px", seam_off, 0.1));
        } else {
            rows.push_back(fails("frame in double, ray in float" + at, " px", seam_off, 1));
            rows.push_back(fails("textbook, float" + at, " px", weak_off, 1));
        }
    }
    return rows;
}

}  // namespace

std::vector<StabilityCase> camera_cases() {
    return {{"UP-PARALLEL",
             "The up vector along the view leaves `right` undefined; nearly along it, all digits of their cross "
             "product are rounding.",
             up_parallel},
            {"FOV-LIMITS",
             "At 0 degrees the picture has no size, at 180 degrees an infinite one; near 180 the tangent has a pole.",
             fov_limits},
            {"EYE-AT-TARGET",
             "With the eye at its target there is no view; very near it, the square of the distance underflows.",
             eye_at_target},
            {"CAMERA-SCALE",
             "A camera and its scene scaled by a power of two are the same camera: the same frame, bit for bit.",
             camera_scale},
            {"FAR-CAMERA", "Far from the origin a float holds no centimetres: at 10 000 km its steps are a metre.",
             far_camera}};
}

}  // namespace raylab::ray_generation
