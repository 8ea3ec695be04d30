#include "01_picture_ray/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "whole_numbers.h"
#include "words.h"

#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/image/to_pixel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::grading {

namespace {

using namespace picture_rays;
using enum CameraFrame::Projection;

constexpr double tolerance = 1e-12;  // of a unit direction; of the origin in proportion to the picture's size

Case make(const std::string& group, Case::Kind kind, const CameraFrame& frame, double x, double y) {
    Case question{group, kind, {}};
    for (const Vec3d& v : {frame.eye, frame.right, frame.up, frame.forward})
        question.input.insert(question.input.end(), {v.x, v.y, v.z});
    question.input.insert(question.input.end(),
                          {frame.half_width, frame.half_height, frame.projection == perspective ? 0.0 : 1.0,
                           static_cast<double>(frame.image.width), static_cast<double>(frame.image.height), x, y});
    return question;
}

CameraFrame looking(const Camera& camera, ImageSize image) { return camera_frame(camera, image, "exercise 01"); }

Camera anywhere(Dice& dice, std::variant<Perspective, Orthographic> projection) {
    const Vec3d position = dice.point(-5, 5);
    return {
        .position = position, .target = position + dice.direction(), .up = dice.direction(), .projection = projection};
}

Case simple(Dice& dice) {
    const auto frame =
        looking({.position = {0, 0, 0}, .target = {0, 0, -1}, .projection = Perspective{90}}, {100, 100});
    return make("eye at the origin, looking along -z, 90 degrees", Case::Kind::graded, frame, dice.in(0, 100),
                dice.in(0, 100));
}

Case square(Dice& dice) {
    const auto frame = looking(anywhere(dice, Perspective{dice.in(20, 100)}), {64, 64});
    return make("any camera, square picture", Case::Kind::graded, frame, dice.in(0, 64), dice.in(0, 64));
}

Case wide(Dice& dice) {
    const auto frame = looking(anywhere(dice, Perspective{dice.in(20, 100)}), {320, 180});
    return make("any camera, wide picture", Case::Kind::graded, frame, dice.in(0, 320), dice.in(0, 180));
}

Case pixel_centre(Dice& dice) {
    const auto frame = looking(anywhere(dice, Perspective{50}), {8, 6});
    return make("pixel centres of a coarse picture", Case::Kind::graded, frame, std::floor(dice.in(0, 8)) + 0.5,
                std::floor(dice.in(0, 6)) + 0.5);
}

Case parallel(Dice& dice) {
    const auto frame = looking(anywhere(dice, Orthographic{dice.in(0.5, 10)}), {200, 150});
    return make("orthographic", Case::Kind::graded, frame, dice.in(0, 200), dice.in(0, 150));
}

// Half of an odd number is no whole one; and what is wide here is as often high.
Case odd(Dice& dice) {
    const int some = 2 * whole(dice, 2, 20) + 1, other = whole(dice, 5, 60);
    const ImageSize image = heads(dice) ? ImageSize{some, other} : ImageSize{other, some};
    const auto camera =
        heads(dice) ? anywhere(dice, Perspective{dice.in(20, 100)}) : anywhere(dice, Orthographic{dice.in(0.5, 10)});
    return make("an odd width or height, and any shape", Case::Kind::graded, looking(camera, image),
                dice.in(0, image.width), dice.in(0, image.height));
}

Case far_eye(Dice& dice) {
    auto camera = anywhere(dice, Perspective{40});
    camera.position *= 1e6;
    camera.target = camera.position + dice.direction() * 1e3;
    return make("an eye a thousand kilometres from the origin", Case::Kind::adversarial, looking(camera, {320, 180}),
                dice.in(0, 320), dice.in(0, 180));
}

Case fisheye(Dice& dice) {
    return make("179.99 degrees", Case::Kind::adversarial, looking(anywhere(dice, Perspective{179.99}), {320, 180}),
                dice.in(0, 320), dice.in(0, 180));
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(40, simple);
    add(40, square);
    add(60, wide);
    add(40, pixel_centre);
    add(60, parallel);
    add(60, odd);
    add(40, far_eye);
    add(40, fisheye);
    return all;
}

std::string ray_words(const Vec3d& origin, const Vec3d& direction) {
    return "from " + words(origin) + " along " + words(direction);
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto expected = truth(arguments(question.input));
    const Vec3d origin{answer[0], answer[1], answer[2]};
    const Vec3d direction{answer[3], answer[4], answer[5]};
    Judgement result{.expected = ray_words(expected.origin, expected.direction), .got = ray_words(origin, direction)};
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); })) {
        result.outcome = Judgement::Outcome::nonfinite;
        return result;
    }
    const double scale = std::max(1.0, glm::length(expected.origin));
    if (glm::length(origin - expected.origin) <= tolerance * scale &&
        glm::length(direction - expected.direction) <= tolerance)
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const auto& frame = given.frame;
    const auto [right, up] = picture_point(given);
    return fmt::format("camera     eye {}, forward {}, right {}, up {}\n           {}, half width {}, half height {}\n"
                       "picture    {} x {} pixels, the point x = {}, y = {}\n"
                       "That point lies {:.6g} to the right and {:.6g} upward of the picture's middle{}.",
                       words(frame.eye), words(frame.forward), words(frame.right), words(frame.up),
                       frame.projection == perspective ? "perspective" : "orthographic", frame.half_width,
                       frame.half_height, frame.image.width, frame.image.height, given.x, given.y, right, up,
                       frame.projection == perspective ? ", where the picture stands at distance 1" : "");
}

// A chequered floor and three spheres, so that a flipped, stretched or shifted picture is noticed at once.
constexpr int picture_width = 240;
constexpr int picture_height = 160;

std::vector<Case> pixel_cases(int x, int y) {
    static const auto frame =
        looking({.position = {2.5, 1.8, 4}, .target = {0.2, 0.6, 0}, .projection = Perspective{45}},
                {picture_width, picture_height});
    return {make("", Case::Kind::graded, frame, x + 0.5, y + 0.5)};
}

Pixel seen_along(const RayOf<double>& ray) {
    static const std::vector<std::pair<SphereOf<double>, Vec3d>> spheres{{{{0, 0.7, 0}, 0.7}, {0.90, 0.45, 0.13}},
                                                                         {{{1.4, 0.4, 0.3}, 0.4}, {0.13, 0.55, 0.80}},
                                                                         {{{-1.1, 0.5, 0.6}, 0.5}, {0.16, 0.62, 0.45}}};
    double nearest = std::numeric_limits<double>::infinity();
    Vec3d color{0.55, 0.70, 0.90};
    if (ray.direction.y < 0) {
        nearest = -ray.origin.y / ray.direction.y;
        const Vec3d point = ray.origin + nearest * ray.direction;
        const bool dark = (static_cast<long>(std::floor(point.x)) + static_cast<long>(std::floor(point.z))) % 2 != 0;
        color = dark ? Vec3d{0.25, 0.25, 0.28} : Vec3d{0.85, 0.84, 0.80};
    }
    for (const auto& [sphere, paint] : spheres) {
        const auto t = nearest_sphere_hit({ray.origin, ray.direction, {0, nearest}}, sphere);
        if (!t) continue;
        nearest = *t;
        const Vec3d normal = (ray.origin + *t * ray.direction - sphere.center) / sphere.radius;
        color = paint * (0.35 + 0.65 * std::max(0.0, dot(normal, glm::normalize(Vec3d{1, 2, 1.5}))));
    }
    return to_pixel(color);
}

bool is_ray(std::span<const double> answer) {
    return std::ranges::all_of(answer, [](double value) { return std::isfinite(value) && std::abs(value) < 1e9; });
}

Pixel shade(int, int, std::span<const double> a) {
    if (!is_ray(a)) return {};
    return seen_along({{a[0], a[1], a[2]}, {a[3], a[4], a[5]}, {}});
}

}  // namespace

Exercise picture_ray_exercise() {
    return exercise_on(picture_ray_slot, answer,
                       {.chart = "pixel_samples",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::vector, "the eye", 3},
                                      {Part::Kind::direction, "right", 3},
                                      {Part::Kind::direction, "up", 3},
                                      {Part::Kind::direction, "forward", 3},
                                      {Part::Kind::number, "half_width"},
                                      {Part::Kind::number, "half_height"},
                                      {Part::Kind::flag, "whether it is orthographic", 1},
                                      {Part::Kind::indices, "the picture's size", 2},
                                      {Part::Kind::number, "x"},
                                      {Part::Kind::number, "y"}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::vector, "the origin", 3}, {Part::Kind::vector, "the direction", 3}},
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "three spheres on a checkered floor, through the rays of the function",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
