#include "05_phong_specular/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "one_number.h"
#include "symptoms.h"
#include "words.h"

#include "raylab/geometry/degree.h"
#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace raylab::grading {

namespace {

using namespace highlight;

constexpr double tolerance = 1e-9;  // a highlight is at most 1

Case make(const std::string& group, Case::Kind kind, const Arguments& given) {
    Case question{group, kind, {}};
    for (const Vec3d& v : {given.normal, given.to_light, given.to_viewer})
        question.input.insert(question.input.end(), {v.x, v.y, v.z});
    question.input.push_back(given.shininess);
    return question;
}

Vec3d across(Dice& dice, const Vec3d& axis) { return glm::normalize(cross(axis, dice.direction())); }

// A light `incline` degrees from the normal, and a viewer `off` degrees from its mirror direction; all vectors have
// length 1.
Arguments placed(Dice& dice, double incline, double off, double shininess) {
    const Vec3d normal = dice.direction(), side = across(dice, normal);
    const Vec3d to_light = std::cos(incline * degree) * normal + std::sin(incline * degree) * side;
    const Vec3d mirrored = std::cos(incline * degree) * normal - std::sin(incline * degree) * side;
    const Vec3d viewer = std::cos(off * degree) * mirrored + std::sin(off * degree) * across(dice, mirrored);
    return {normal, to_light, viewer, shininess};
}

// From here on the viewer is always in front of the surface, and no angle that decides is within a degree of a right
// angle.
Arguments before_surface(Dice& dice, double smallest_offset, double largest_offset, double shininess) {
    while (true) {
        const double incline = dice.in(5, 80);
        const Arguments given = placed(dice, incline, dice.in(smallest_offset, largest_offset), shininess);
        if (dot(given.normal, given.to_viewer) > std::sin(degree)) return given;
    }
}

double whole(Dice& dice, double low, double high) { return std::round(dice.in(low, high)); }

Case in_the_mirror(Dice& dice) {
    return make("viewer in the mirror direction", Case::Kind::graded,
                placed(dice, dice.in(5, 80), 0, whole(dice, 1, 200)));
}

Case near_it(Dice& dice) {
    return make("viewer near it", Case::Kind::graded, before_surface(dice, 2, 35, whole(dice, 1, 12)));
}

Case far_from_it(Dice& dice) {
    return make("viewer more than a right angle from it", Case::Kind::graded,
                before_surface(dice, 91, 150, whole(dice, 1, 4)));
}

// The mirror direction of a light behind the surface is behind it too, so a careless formula sees a highlight there.
Case light_behind(Dice& dice) {
    const Arguments given = placed(dice, dice.in(100, 175), 0, whole(dice, 1, 4));
    const Vec3d mirrored = given.to_viewer;
    const Vec3d viewer = glm::normalize(mirrored + (0.1 - dot(mirrored, given.normal)) * given.normal);
    return make("light behind the surface", Case::Kind::graded,
                {given.normal, given.to_light, viewer, given.shininess});
}

Case broken_exponent(Dice& dice) {
    return make("broken exponents", Case::Kind::graded, before_surface(dice, 5, 50, dice.in(0.3, 9.7)));
}

// Where the angle is less than a right one the highlight is 1, and elsewhere 0: nothing to the power of 0 is 1.
Case without_shininess(Dice& dice) {
    const bool seen = dice.in(0, 1) < 0.5;
    auto given = seen ? before_surface(dice, 2, 80, 0) : before_surface(dice, 95, 150, 0);
    if (!seen && dice.in(0, 1) < 0.3) given.to_light = -given.to_light;
    return make("a shininess of 0", Case::Kind::graded, given);
}

// A light low over the surface: what is near its mirror direction may be below it.
Case viewer_behind(Dice& dice) {
    while (true) {
        const double incline = dice.in(70, 88);
        const Arguments given = placed(dice, incline, dice.in(5, 40), whole(dice, 1, 8));
        if (dot(given.normal, given.to_viewer) < -std::sin(degree))
            return make("viewer behind the surface", Case::Kind::graded, given);
    }
}

// One of the three vectors has any length.
Case any_length(Dice& dice, const std::string& group, Vec3d Arguments::*vector) {
    auto given = before_surface(dice, 2, 35, whole(dice, 1, 8));
    given.*vector *= dice.in(0.2, 1) * (dice.in(0, 1) < 0.5 ? 1 : 9);
    return make(group, Case::Kind::graded, given);
}

Case nearly_mirror(Dice& dice) {
    return make("a shininess of a million", Case::Kind::adversarial, before_surface(dice, 0, 0.2, 1e6));
}

Case long_and_short(Dice& dice) {
    auto given = before_surface(dice, 5, 50, whole(dice, 1, 8));
    given.normal *= std::pow(10, dice.in(-60, 60));
    given.to_light *= std::pow(10, dice.in(-60, 60));
    given.to_viewer *= std::pow(10, dice.in(-60, 60));
    return make("vectors of astronomical and of atomic length", Case::Kind::adversarial, given);
}

Case grazing(Dice& dice) {
    return make("a light on the horizon", Case::Kind::adversarial, placed(dice, 90 - 1e-7, 0, whole(dice, 1, 50)));
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(20, in_the_mirror);
    add(40, near_it);
    add(40, far_from_it);
    add(40, light_behind);
    add(40, broken_exponent);
    add(30, without_shininess);
    add(20, viewer_behind);
    add(40, [](Dice& d) { return any_length(d, "normal of any length", &Arguments::normal); });
    add(40, [](Dice& d) { return any_length(d, "light at any distance", &Arguments::to_light); });
    add(40, [](Dice& d) { return any_length(d, "viewer at any distance", &Arguments::to_viewer); });
    add(40, nearly_mirror);
    add(40, long_and_short);
    add(40, grazing);
    return all;
}

// The truth is computed by geometry, not by the formula under test: the angle between the light and the mirror image of
// the viewer, by its tangent, all in long double.
struct Truth {
    double incline, off;  // in degrees: of the light from the normal, of the viewer from the mirror direction
    double highlight;
};

template <class V>
long double angle_between(const V& a, const V& b) {
    return std::atan2(glm::length(cross(a, b)), dot(a, b));
}

Truth truth(const Arguments& given) {
    const auto unit = [](const Vec3d& v) { return glm::normalize(convert<long double>(v)); };
    const auto normal = unit(given.normal), light = unit(given.to_light), viewer = unit(given.to_viewer);
    const auto in_plane = dot(viewer, normal) * normal;
    const auto image = in_plane - (viewer - in_plane);  // of the viewer, on the light's side
    const long double incline = angle_between(normal, light), off = angle_between(image, light),
                      right = std::numbers::pi_v<long double> / 2;
    Truth found{static_cast<double>(incline / degree), static_cast<double>(off / degree), 0};
    if (incline < right && off < right)
        found.highlight = static_cast<double>(std::pow(std::cos(off), static_cast<long double>(given.shininess)));
    return found;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    return judged_number(truth(arguments(question.input)).highlight, answer[0], tolerance);
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const auto [incline, off, highlight] = truth(given);
    const std::string why = incline > 90 ? "so it is behind the surface, which has no highlight of it"
                            : off > 90
                                ? fmt::format("and the viewer {:.4g} degrees from its mirror direction: too far", off)
                                : fmt::format("and the viewer {:.4g} degrees from its mirror direction", off);
    return fmt::format(
        "normal     {}\nto light   {}\nto viewer  {}\nshininess  {}\nThe light stands {:.4g} degrees from the normal, "
        "{}.",
        words(given.normal), words(given.to_light), words(given.to_viewer), words(given.shininess), incline, why);
}

// Three balls, dull to shiny, under one light. No vector is normalised: normals are as long as the radius.
struct Ball {
    SphereOf<double> sphere;
    double shininess;
};
constexpr std::array<Ball, 3> balls{{{{{-1.25, 0, 0}, 0.6}, 4}, {{{0, 0, 0}, 0.6}, 20}, {{{1.25, 0, 0}, 0.6}, 120}}};
constexpr Vec3d light{-2, 3, 4}, eye{0, 0, 6};
constexpr int picture_width = 300;
constexpr int picture_height = 120;

struct Seen {
    const Ball* ball = nullptr;
    Vec3d point{0, 0, 0};
};

Seen seen_at(int x, int y) {
    const double scale = 1.7 / picture_height;  // metres for each pixel, in the plane of the balls' centers
    const Vec3d target{(x + 0.5 - 0.5 * picture_width) * scale, (0.5 * picture_height - y - 0.5) * scale, 0};
    const RayOf<double> ray{eye, target - eye, {0, std::numeric_limits<double>::infinity()}};
    for (const Ball& ball : balls)  // none occludes another
        if (const auto t = nearest_sphere_hit(ray, ball.sphere)) return {&ball, ray.origin + *t * ray.direction};
    return {};
}

std::vector<Case> pixel_cases(int x, int y) {
    const auto [ball, point] = seen_at(x, y);
    const Ball& asked = ball ? *ball : balls[0];
    return {make("", Case::Kind::graded,
                 {ball ? point - asked.sphere.center : Vec3d{0, 0, 1}, light - point, eye - point, asked.shininess})};
}

Pixel shade(int x, int y, std::span<const double> answer) {
    const auto [ball, point] = seen_at(x, y);
    if (!ball || !std::isfinite(answer[0])) return {0.02f, 0.03f, 0.06f};
    const double lit =
        0.1 + 0.7 * std::max(0.0, dot(glm::normalize(point - ball->sphere.center), glm::normalize(light - point)));
    const double shine = 0.7 * std::clamp(answer[0], 0.0, 1.0);
    return {cast<float>(0.55 * lit + shine), cast<float>(0.12 * lit + shine), cast<float>(0.10 * lit + shine)};
}

}  // namespace

Exercise phong_specular_exercise() {
    return exercise_on(phong_specular_slot, answer,
                       {.chart = "phong_specular",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::direction, "the normal", 3},
                                      {Part::Kind::direction, "the way to the light", 3},
                                      {Part::Kind::direction, "the way to the viewer", 3},
                                      {Part::Kind::number, "the shininess"}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::number, "the highlight"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "three balls, dull to shiny, with the highlights of the function",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
