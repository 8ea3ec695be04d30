#include "06_shadow/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "ground.h"
#include "known.h"
#include "picture.h"
#include "symptoms.h"
#include "truth.h"
#include "whole_numbers.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace shadow;

Case make(const std::string& group, Case::Kind kind, const Arguments& given) {
    Case question{group, kind, {}};
    const auto put = [&](const Vec3d& v) { question.input.insert(question.input.end(), {v.x, v.y, v.z}); };
    put(given.point);
    put(given.normal);
    put(given.light);
    question.input.push_back(given.above);
    for (const auto& sphere : given.spheres) {
        put(sphere.center);
        question.input.push_back(sphere.radius);
    }
    return question;
}

Case free_way(Dice& dice) {
    return make("nothing in the way", Case::Kind::graded, open_ground(dice, 1, some_distance(dice)));
}

Case below_surface(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.above = 1e-12 * largest_coordinate(given.point);
    return make("a point a hair under its surface", Case::Kind::graded, given);
}

Case between(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.spheres[0] = on_way(dice, given, dice.in(0.2, 0.8));
    return make("something between", Case::Kind::graded, given);
}

Case beyond_light(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.spheres[1] = on_way(dice, given, dice.in(1.3, 2.5));
    return make("something beyond the light", Case::Kind::graded, given);
}

Case behind_point(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.above = -1e-12 * largest_coordinate(given.point);
    given.spheres[2] = on_way(dice, given, dice.in(-0.8, -0.2));
    return make("something behind the point", Case::Kind::graded, given);
}

Case light_behind(Dice& dice) {
    auto given = open_ground(dice, 1, some_distance(dice));
    given.normal = -given.normal;
    return make("a light behind the surface", Case::Kind::graded, given);
}

Case close_by(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d to_light = glm::normalize(given.light - given.point);
    const double gap = dice.in(1e-4, 4e-4);
    // Not larger than the gap, so that the segment to the light soon leaves it behind.
    const double radius = gap * dice.in(0.2, 0.8);
    given.spheres[3] = {given.point + to_light * (gap + radius), radius};
    given.above = -1e-12 * largest_coordinate(given.point);
    return make("something very close", Case::Kind::graded, given);
}

Case anything(Dice& dice, const std::string& group, double scale) {
    auto given = open_ground(dice, scale, dice.in(2, 10));
    for (std::size_t i = 0; i < 3; ++i) given.spheres[i] = on_way(dice, given, dice.in(0.1, 2));
    for (auto& sphere : given.spheres)
        if (dice.in(0, 1) < 0.6) sphere.radius = 0;
    return make(group, Case::Kind::graded, given);
}

Case under_large(Dice& dice) {
    auto given = open_ground(dice, 1e5, dice.in(2, 10));
    given.above = 1e-12 * largest_coordinate(given.point);
    return make("a hundred kilometres, a hair under the surface", Case::Kind::graded, given);
}

Case close_in_small(Dice& dice) {
    auto given = open_ground(dice, 1e-4, dice.in(2, 10));
    given.spheres[0] = on_way(dice, given, dice.in(0.2, 0.6));
    return make("a tenth of a millimetre, something between", Case::Kind::graded, given);
}

// What is close in a small scene: an offset that is small in a room passes over it.
Case very_close_in_small(Dice& dice) {
    auto given = open_ground(dice, 1e-4, dice.in(2, 10));
    const Vec3d to_light = glm::normalize(given.light - given.point);
    const double gap = 1e-4 * dice.in(1e-4, 4e-4), radius = gap * dice.in(0.2, 0.8);
    given.spheres[3] = {given.point + to_light * (gap + radius), radius};
    given.above = -1e-12 * largest_coordinate(given.point);
    return make("a tenth of a millimetre, something very close", Case::Kind::graded, given);
}

// All of a small scene, a hundred kilometres off: a hair is as long as the coordinates are large, and nothing else is.
Case far_from_origin(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d away = dice.direction() * 1e5;
    given.point += away;
    given.light += away;
    given.above = (heads(dice) ? 1e-12 : -1e-12) * largest_coordinate(given.point);
    if (heads(dice)) given.spheres[0] = on_way(dice, given, dice.in(0.3, 0.7));
    return make("a small scene far from the origin", Case::Kind::graded, given);
}

// The light is a hundred kilometres away, and a hair is as long as that says; what casts a shadow, a few metres.
Case far_light(Dice& dice) {
    auto given = open_ground(dice, 1, 1e5);
    given.above = (heads(dice) ? 1e-12 : -1e-12) * largest_coordinate(given.light);
    const Vec3d to_light = glm::normalize(given.light - given.point);
    const double gap = dice.in(2, 8), radius = gap * dice.in(0.2, 0.8);
    if (heads(dice)) given.spheres[1] = {given.point + to_light * (gap + radius), radius};
    return make("a near thing, a far light", Case::Kind::graded, given);
}

Case before_light(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d way = given.light - given.point;
    const double radius = 0.01 * glm::length(way) * dice.in(0.1, 0.4);
    given.spheres[2] = {given.light - way * dice.in(0.005, 0.008), radius};
    return make("something just before the light", Case::Kind::graded, given);
}

// The light is less than a degree above the surface.
Case low_light(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d along = glm::normalize(cross(given.normal, dice.direction()));
    const double rise = dice.in(0.003, 0.015);
    given.light = given.point + (along + rise * given.normal) * dice.in(2, 10);
    given.above = (heads(dice) ? 1e-12 : -1e-12) * largest_coordinate(given.point);
    if (heads(dice)) given.spheres[3] = on_way(dice, given, dice.in(0.3, 0.7));
    return make("a light low over the surface", Case::Kind::graded, given);
}

Case light_on_ball(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d out = glm::normalize(given.light - given.point + dice.direction());
    given.spheres[0] = {given.light + out * 0.5, 0.5};
    return make("a light that touches a ball", Case::Kind::adversarial, given);
}

Case grazing(Dice& dice) {
    auto given = open_ground(dice, 1, dice.in(2, 10));
    const Vec3d way = given.light - given.point;
    const Vec3d aside = glm::normalize(cross(way, dice.direction()));
    given.spheres[0] = {given.point + way * 0.5 + aside, 1 + (dice.in(0, 1) < 0.5 ? -1e-9 : 1e-9)};
    return make("a way that grazes a ball", Case::Kind::adversarial, given);
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            if (question.kind == Case::Kind::graded && !keeps_margin(arguments(question.input))) continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    add(30, free_way);
    add(30, below_surface);
    add(40, between);
    add(40, beyond_light);
    add(30, behind_point);
    add(30, light_behind);
    add(30, close_by);
    add(40, [](Dice& d) { return anything(d, "several spheres", 1); });
    add(20, under_large);
    add(20, close_in_small);
    add(20, very_close_in_small);
    add(30, far_from_origin);
    add(20, far_light);
    add(20, before_light);
    add(40, low_light);
    add(30, light_on_ball);
    add(30, grazing);
    return all;
}

std::string in_words(bool dark) { return dark ? "in shadow" : "lit"; }

Judgement judge(const Case& question, std::span<const double> answer) {
    const bool expected = is_dark(arguments(question.input));
    Judgement result{.expected = in_words(expected), .got = in_words(answer[0] != 0)};
    if (!std::isfinite(answer[0]))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (answer[0] == (expected ? 1 : 0))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    std::string words_ = fmt::format("point   {}\nnormal  {}\nlight   {}\n", words(given.point), words(given.normal),
                                     words(given.light));
    for (const auto& sphere : given.spheres) {
        if (sphere.radius == 0) continue;
        const auto clear = static_cast<double>(clearance(given, sphere));
        words_ += fmt::format("sphere  at {}, radius {:.4g}: {}\n", words(sphere.center), sphere.radius,
                              clear < 0 ? "in the way" : fmt::format("not in the way, {:.3g} from it", clear));
    }
    return words_ + fmt::format("The surface is {:.2g} {} the point (rounding); the light "
                                "is {} it.",
                                std::abs(given.above), given.above > 0 ? "above" : "below",
                                is_behind(given) ? "behind" : "before");
}

std::vector<Case> pixel_cases(int x, int y) {
    const Seen seen = seen_at(x, y);
    // As rounding would: above and below in stripes.
    const double above =
        2e-12 * std::sin(9 * seen.point.x + 23 * seen.point.z) * std::max(1.0, largest_coordinate(seen.point)) / 2;
    return {make("", Case::Kind::graded, {seen.point, seen.normal, light, above, balls})};
}

Pixel shade(int x, int y, std::span<const double> answer) {
    const Seen seen = seen_at(x, y);
    if (!seen.hit || !std::isfinite(answer[0])) return {0.02f, 0.03f, 0.06f};
    const Vec3d to_light = glm::normalize(light - seen.point);
    const double lit = 0.15 + (answer[0] != 0 ? 0 : 0.85 * std::max(0.0, dot(seen.normal, to_light)));
    return {cast<float>(seen.color.x * lit), cast<float>(seen.color.y * lit), cast<float>(seen.color.z * lit)};
}

}  // namespace

Exercise shadow_exercise() {
    return exercise_on(in_shadow_slot, answer,
                       {.chart = "shadow_ray",
                        .inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::flag, "a shadow"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "balls about a light, with the shadows of the function",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
