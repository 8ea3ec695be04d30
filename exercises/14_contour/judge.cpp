#include "14_contour/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "one_number.h"
#include "picture.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::grading {

namespace {

using namespace contour;

// Of a polygon seen under 3e-4 the plainest right answers lose eight digits,
// and acos loses ten or more.
constexpr double tolerance = 3e-8;
constexpr double of_nothing = 1e-12;  // where nothing arrives

Case make(const std::string& group, Case::Kind kind, const Arguments& given) { return {group, kind, as_input(given)}; }

Case graded(const std::string& group, const Arguments& given) { return make(group, Case::Kind::graded, given); }

// Three to six vertices on a circle, counter-clockwise around the normal.
std::vector<Vec3d> polygon_around(Dice& dice, const Vec3d& center, const Vec3d& normal, double radius) {
    const Vec3d x = glm::normalize(cross(normal, dice.direction())), y = cross(normal, x);
    const auto vertices = static_cast<std::size_t>(dice.in(3, 6.999));
    std::vector<Vec3d> polygon;
    for (std::size_t i = 0; i < vertices; ++i) {
        const double angle =
            2 * std::numbers::pi * (static_cast<double>(i) + dice.in(0, 0.6)) / static_cast<double>(vertices);
        polygon.push_back(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
    }
    return polygon;
}

// A polygon around point + way that faces the point; way has a length.
Arguments facing(Dice& dice, const Vec3d& point, const Vec3d& normal, const Vec3d& way, double radius) {
    const Vec3d towards = glm::normalize(-glm::normalize(way) + 0.5 * dice.direction());
    return {point, normal, polygon_around(dice, point + way, towards, radius)};
}

// A direction whose cosine with an axis is between two numbers.
Vec3d leaning(Dice& dice, const Vec3d& axis, double least, double most) {
    const double cosine = dice.in(least, most);
    return cosine * axis + std::sqrt(1 - cosine * cosine) * glm::normalize(cross(axis, dice.direction()));
}

Arguments above(Dice& dice) {
    const Vec3d point = dice.point(-5, 5), normal = dice.direction();
    const double distance = dice.in(1, 5);
    return facing(dice, point, normal, distance * leaning(dice, normal, 0.6, 1), dice.in(0.1, 0.55) * distance);
}

Case straight_above(Dice& dice) {
    const Vec3d point = dice.point(-5, 5), normal = dice.direction();
    const Vec3d x = glm::normalize(cross(normal, dice.direction())), y = cross(normal, x);
    const double a = dice.in(0.5, 4), b = dice.in(0.5, 4);
    const Vec3d center = point + normal;
    return graded("a rectangle straight above",
                  {point,
                   normal,
                   {center - a * x - b * y, center - a * x + b * y, center + a * x + b * y, center + a * x - b * y}});
}

Case above_horizon_case(Dice& dice) { return graded("above the horizon", above(dice)); }

Case across_horizon(Dice& dice) {
    for (;;) {
        const Vec3d point = dice.point(-5, 5), normal = dice.direction();
        const double distance = dice.in(1, 5), radius = dice.in(0.3, 0.8) * distance;
        const Arguments given = facing(dice, point, normal, distance * leaning(dice, normal, -0.5, 0.5), radius);
        const Heights height = heights(given);
        if (height.least < -0.1 * radius && height.most > 0.1 * radius && truth(given) > 1e-3)
            return graded("across the horizon", given);
    }
}

Case below_horizon(Dice& dice) {
    Arguments given = above(dice);
    given.normal = -given.normal;
    return graded("below the horizon", given);
}

Case from_behind(Dice& dice) {
    Arguments given = above(dice);
    std::ranges::reverse(given.polygon);
    return graded("seen from behind", given);
}

Case of_any_size(Dice& dice) {
    Arguments given = arguments((dice.in(0, 1) < 0.5 ? across_horizon(dice) : graded("", above(dice))).input);
    const double unit = dice.in(0, 1) < 0.5 ? 1e-6 : 1e6;
    given.point *= unit;
    for (Vec3d& vertex : given.polygon) vertex *= unit;
    return graded("a micrometre, and a thousand kilometres", given);
}

Case small_and_far(Dice& dice) {
    const Vec3d normal = dice.direction();
    return graded("small and far", facing(dice, {0, 0, 0}, normal, leaning(dice, normal, 0.4, 1), dice.in(3e-4, 6e-4)));
}

Case tiny(Dice& dice) {
    const Vec3d normal = dice.direction();
    return make("a millionth of its distance", Case::Kind::adversarial,
                facing(dice, {0, 0, 0}, normal, leaning(dice, normal, 0.4, 1), 1e-6));
}

Case in_its_plane(Dice& dice) {
    const Vec3d normal{0, 0, dice.in(0, 1) < 0.5 ? 1.0 : -1.0};
    const std::vector<Vec3d> floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    return make("a point in the polygon's plane", Case::Kind::adversarial,
                {{std::round(dice.in(-2, 4)) / 2, std::round(dice.in(-2, 4)) / 2, 0}, normal, floor});
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(30, straight_above);
    add(60, above_horizon_case);
    add(60, across_horizon);
    add(20, below_horizon);
    add(20, from_behind);
    add(20, of_any_size);
    add(30, small_and_far);
    add(30, tiny);
    add(20, in_its_plane);
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const double expected = truth(arguments(question.input));
    return judged_number(expected, answer[0], expected > 0 ? tolerance * expected : of_nothing);
}

std::string story(const Case& question) {
    const Arguments given = arguments(question.input);
    const Heights height = heights(given);
    std::string vertices;
    for (const Vec3d& vertex : given.polygon) vertices += fmt::format("\nvertex     {}", words(vertex));
    const std::string where = height.most <= 0    ? "All of the polygon is below the horizon."
                              : height.least >= 0 ? "All of the polygon is above the horizon."
                                                  : "The horizon cuts the polygon.";
    return fmt::format("point      {}\nnormal     {}{}\nIts vertices are from "
                       "{:.4g} to {:.4g} above the point's horizon. {}",
                       words(given.point), words(given.normal), vertices, height.least, height.most, where);
}

std::vector<Case> pixel_cases(int x, int y) {
    const Seen seen = seen_at(x, y);
    return {graded("", {seen.point, seen.normal, panel()})};
}

Pixel shade(int x, int y, std::span<const double> answer) {
    const Seen seen = seen_at(x, y);
    if (seen.what == Seen::What::sky) return {0.02f, 0.03f, 0.06f};
    if (seen.what == Seen::What::panel) return {1, 0.85f, 0.6f};
    if (!std::isfinite(answer[0])) return {0.8f, 0, 0.5f};
    if (answer[0] < 0) return {0, 0.15f, 0.5f};  // light cannot be negative: blue
    const double light = std::min(1.0, 2 * answer[0]);
    return {cast<float>(light), cast<float>(0.85 * light), cast<float>(0.6 * light)};
}

}  // namespace

Exercise contour_exercise() {
    return exercise_on(contour_form_factor_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::vector, "the point", 3},
                                      {Part::Kind::direction, "the normal", 3},
                                      {Part::Kind::indices, "how many vertices", 1},
                                      {Part::Kind::vector, "a vertex", 3},
                                      {Part::Kind::vector, "a vertex", 3},
                                      {Part::Kind::vector, "a vertex", 3},
                                      {Part::Kind::vector, "a vertex", 3},
                                      {Part::Kind::vector, "a vertex", 3},
                                      {Part::Kind::vector, "a vertex", 3}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::number, "the form factor"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a ball and a floor in the light of a leaning "
                                             "panel, half below the floor",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
