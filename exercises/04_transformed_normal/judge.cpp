#include "04_transformed_normal/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "whole_numbers.h"
#include "words.h"

#include "raylab/geometry/affine.h"
#include "raylab/geometry/nearest_sphere_hit.h"

#include <algorithm>
#include <limits>

namespace raylab::grading {

namespace {

using namespace normals;
using Columns = std::array<Vec3d, 3>;

constexpr double tolerance = 1e-9;  // of a unit vector
constexpr double best_conditioned =
    0.02;  // |det| over the product of the columns' lengths: flatter maps are adversarial

Case make(const std::string& group, Case::Kind kind, const Columns& columns, const Vec3d& normal) {
    Case question{group, kind, {}};
    for (const Vec3d& v : {columns[0], columns[1], columns[2], normal})
        question.input.insert(question.input.end(), {v.x, v.y, v.z});
    return question;
}

Columns rotation(Dice& dice) { return AffineSteps::rotate(dice.direction(), dice.in(20, 340)).columns; }

Columns scaled(Columns columns, const Vec3d& by) { return {columns[0] * by.x, columns[1] * by.y, columns[2] * by.z}; }

Case unchanged(Dice& dice) {
    return make("identity", Case::Kind::graded, {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}, dice.direction());
}

Case rotated(Dice& dice) { return make("rotations", Case::Kind::graded, rotation(dice), dice.direction()); }

Case scaled_alike(Dice& dice) {
    const double by = dice.in(0.1, 8);
    return make("uniform scales", Case::Kind::graded, scaled(rotation(dice), {by, by, by}), dice.direction());
}

Case scaled_apart(Dice& dice) {
    const double x = dice.in(0.3, 4), y = dice.in(0.3, 4);
    return make("non-uniform scales", Case::Kind::graded,
                {Vec3d{x, 0, 0}, Vec3d{0, y, 0}, Vec3d{0, 0, dice.in(0.3, 4)}}, dice.direction());
}

Case sheared(Dice& dice) {
    const double by = dice.in(0.3, 2);
    return make("shears", Case::Kind::graded,
                {Vec3d{1, 0, 0}, Vec3d{by, 1, 0}, Vec3d{dice.in(-1, 1), dice.in(-1, 1), 1}}, dice.direction());
}

Case mirrored(Dice& dice) {
    return make("mirrors", Case::Kind::graded, scaled(rotation(dice), {-1, dice.in(0.5, 2), dice.in(0.5, 2)}),
                dice.direction());
}

Case anything(Dice& dice) {
    const Vec3d a = dice.point(-2, 2), b = dice.point(-2, 2), c = dice.point(-2, 2);
    return make("any map, normals of any length", Case::Kind::graded, {a, b, c}, dice.direction() * dice.in(0.1, 10));
}

Case along_axes(Dice& dice) {
    const Vec3d a = dice.point(-2, 2), b = dice.point(-2, 2), c = dice.point(-2, 2);
    const Vec3d normal = along(whole(dice, 0, 2), sign(dice)) * std::pow(10, dice.in(-1, 1));
    return make("normals along the axes, of any length", Case::Kind::graded, {a, b, c}, normal);
}

Case shrunk(Dice& dice) {
    const double by = std::pow(10, dice.in(-5, -3));
    return make("maps that shrink a thousand times and more", Case::Kind::graded,
                scaled(rotation(dice), Vec3d{1, dice.in(0.5, 2), dice.in(0.5, 2)} * by), dice.direction());
}

// Turned about axes by half a turn, mirrored, or with two axes exchanged.
Case flipped(Dice& dice) {
    Columns columns{along(0, sign(dice)), along(1, sign(dice)), along(2, sign(dice))};
    if (heads(dice)) std::swap(columns[0], columns[static_cast<std::size_t>(whole(dice, 1, 2))]);
    return make("maps that flip axes, or exchange them", Case::Kind::graded, columns, dice.direction());
}

Case nearly_flat(Dice& dice) {
    return make("maps that flatten a million times", Case::Kind::adversarial, scaled(rotation(dice), {1, 1, 1e-6}),
                dice.direction());
}

Case tiny(Dice& dice) {
    return make("maps to a millionth of a millionth", Case::Kind::adversarial,
                scaled(rotation(dice), {1e-12, 2e-12, 3e-12}), dice.direction());
}

double conditioning(const Columns& c) {
    return std::abs(dot(c[0], cross(c[1], c[2]))) / (glm::length(c[0]) * glm::length(c[1]) * glm::length(c[2]));
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            if (question.kind == Case::Kind::graded &&
                conditioning(arguments(question.input).columns) < best_conditioned)
                continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    add(10, unchanged);
    add(40, rotated);
    add(40, scaled_alike);
    add(40, scaled_apart);
    add(40, sheared);
    add(40, mirrored);
    add(60, anything);
    add(30, along_axes);
    add(30, shrunk);
    add(30, flipped);
    add(40, nearly_flat);
    add(40, tiny);
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const Vec3d expected = truth(arguments(question.input));
    const Vec3d got{answer[0], answer[1], answer[2]};
    Judgement result{.expected = words(expected), .got = words(got)};
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (glm::length(got - expected) <= tolerance)
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    return fmt::format("columns    {} {} {}\nnormal     {}\nA tangent of the old surface, carried by the map, must "
                       "stay at right angles to the new normal; the map itself carries the old normal to {}.",
                       words(given.columns[0]), words(given.columns[1]), words(given.columns[2]), words(given.normal),
                       words(mapped(given.columns, given.normal)));
}

// A sheared and flattened sphere, lit from the upper left with its normals.
constexpr int picture_width = 240;
constexpr int picture_height = 180;
const Columns placement{Vec3d{1.1, 0, 0}, Vec3d{0.8, 0.7, 0}, Vec3d{0.2, 0.1, 0.9}};

struct Seen {
    bool hit = false;
    Vec3d normal{0, 0, 1};  // before the transform
};

// The unit sphere under the transform, seen along -z: the ray is transformed by the inverse (columns of adj / det).
Seen seen_at(int x, int y) {
    const double scale = 2.9 / picture_height;  // metres for each pixel
    const Vec3d origin{(x + 0.5 - 0.5 * picture_width) * scale, (0.5 * picture_height - y - 0.5) * scale, 5};
    const auto& [a, b, c] = placement;
    const double determinant = dot(a, cross(b, c));
    const auto back = [&](const Vec3d& v) {
        return Vec3d{dot(v, cross(b, c)), dot(v, cross(c, a)), dot(v, cross(a, b))} / determinant;
    };
    const RayOf<double> ray{back(origin), back({0, 0, -1}), {0, std::numeric_limits<double>::infinity()}};
    const auto t = nearest_sphere_hit(ray, {{0, 0, 0}, 1});
    if (!t) return {};
    return {true, ray.origin + *t * ray.direction};
}

std::vector<Case> pixel_cases(int x, int y) { return {make("", Case::Kind::graded, placement, seen_at(x, y).normal)}; }

Pixel shade(int x, int y, std::span<const double> answer) {
    const Vec3d light = glm::normalize(Vec3d{-1, 1, 1.2});
    const Vec3d normal{answer[0], answer[1], answer[2]};
    if (!seen_at(x, y).hit || !std::isfinite(dot(normal, normal))) return {0.02f, 0.03f, 0.06f};
    // A normal that is too long makes the picture too bright.
    const double lit = 0.1 + 0.9 * std::clamp(dot(normal, light), 0.0, 4.0);
    return {cast<float>(0.90 * lit), cast<float>(0.60 * lit), cast<float>(0.15 * lit)};
}

}  // namespace

Exercise transformed_normal_exercise() {
    return exercise_on(transformed_normal_slot, answer,
                       {.chart = "transformed_normal",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::direction, "the first column", 3},
                                      {Part::Kind::direction, "the second column", 3},
                                      {Part::Kind::direction, "the third column", 3},
                                      {Part::Kind::direction, "the normal", 3}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::vector, "the normal", 3}},
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a sheared sphere, lit by the normals of the function",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
