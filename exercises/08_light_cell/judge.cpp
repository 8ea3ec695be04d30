#include "08_light_cell/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "whole_numbers.h"
#include "words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace raylab::grading {

namespace {

using namespace cells;

Case make(const std::string& group, Case::Kind kind, const Vec3d& direction, int resolution) {
    return {group, kind, {direction.x, direction.y, direction.z, static_cast<double>(resolution)}};
}

// A direction through the middle part of a face, on any axis.
Vec3d through_face(Dice& dice, int face) {
    Vec3d direction = dice.point(-0.95, 0.95);
    direction[face / 2] = face % 2 == 0 ? 1 : -1;
    return direction;
}

Case any_cell(Dice& dice, const std::string& group, int resolution, double length) {
    return make(group, Case::Kind::graded, through_face(dice, whole(dice, 0, 5)) * length, resolution);
}

// Through the last column, or the last row, of a face of thousands of cells: what is cut off before the edge loses it.
Case last_of_thousands(Dice& dice) {
    const int face = whole(dice, 0, 5), resolution = static_cast<int>(std::exp(dice.in(std::log(2e3), std::log(2e4))));
    Vec3d direction = through_face(dice, face);
    direction[(face / 2 + whole(dice, 1, 2)) % 3] = 1 - 2 * dice.in(0.1, 0.9) / resolution;
    return make("the last of thousands of cells", Case::Kind::graded, direction, resolution);
}

// A hundred-thousandth of a cell off a border, where there are thousands: floats, or a small number that is added to be
// safe, lead to the cell beyond it.
Case near_a_border(Dice& dice) {
    const int face = whole(dice, 0, 5), resolution = static_cast<int>(std::exp(dice.in(std::log(2e3), std::log(2e4))));
    Vec3d direction = through_face(dice, face);
    const double off = sign(dice) * dice.in(1e-5, 1e-4);
    direction[(face / 2 + whole(dice, 1, 2)) % 3] = 2 * (whole(dice, 1, resolution - 1) + off) / resolution - 1;
    return make("a hundred-thousandth of a cell off a border", Case::Kind::graded, direction, resolution);
}

// A direction exactly through an edge or a corner of the cube.
Case at_edge(Dice& dice) {
    Vec3d direction = dice.point(-0.95, 0.95);
    const int inside = whole(dice, 0, 3);  // 3: a corner
    for (int axis = 0; axis < 3; ++axis)
        if (axis != inside) direction[axis] = dice.in(0, 1) < 0.5 ? 1 : -1;
    return make("edges and corners of the cube", Case::Kind::graded, direction * std::ldexp(1.0, whole(dice, -3, 3)),
                8);
}

// A direction in which two coordinates, or one, are 0, of either sign.
Case along_axes(Dice& dice) {
    const int face = whole(dice, 0, 5), resolution = heads(dice) ? 8 : 2 * whole(dice, 1, 4) + 1;
    Vec3d direction = through_face(dice, face);
    const int zero = face / 2 + whole(dice, 1, 2);
    direction[zero % 3] = sign(dice) * 0.0;
    if (heads(dice)) direction[3 - face / 2 - zero % 3] = sign(dice) * 0.0;
    return make("along an axis, or across one", Case::Kind::graded, direction * power_of_two(dice, -3, 3), resolution);
}

Case at_border(Dice& dice) {
    const int face = whole(dice, 0, 5), resolution = 16;
    Vec3d direction = through_face(dice, face);
    direction[(face / 2 + 1) % 3] = 2.0 * whole(dice, 0, resolution) / resolution - 1;
    return make("between two cells", Case::Kind::adversarial, direction, resolution);
}

Case very_long(Dice& dice) {
    const double length = std::ldexp(1.0, dice.in(0, 1) < 0.5 ? -1000 : 1000);
    return make("lengths of 1e-301 and 1e301", Case::Kind::adversarial, through_face(dice, whole(dice, 0, 5)) * length,
                16);
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            const bool exact =
                question.group == "edges and corners of the cube" || question.group == "along an axis, or across one";
            if (question.kind == Case::Kind::graded && !exact && !keeps_margin(arguments(question.input))) continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    add(60, [](Dice& d) { return any_cell(d, "eight cells a row", 8, 1); });
    add(40, [](Dice& d) { return any_cell(d, "longer and shorter directions", 8, std::pow(10, d.in(-3, 4))); });
    add(30, [](Dice& d) { return any_cell(d, "a thousand cells a row", 1000, d.in(0.5, 2)); });
    add(30, [](Dice& d) { return any_cell(d, "an odd number of cells", 2 * whole(d, 1, 6) + 1, d.in(0.5, 2)); });
    add(10, [](Dice& d) { return any_cell(d, "one cell a face", 1, 1); });
    add(20, last_of_thousands);
    add(40, at_edge);
    add(40, along_axes);
    add(20, near_a_border);
    add(30, at_border);
    add(20, very_long);
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto given = arguments(question.input);
    const LightCell expected = found_cell(given);
    Judgement result{.expected = cell_words(expected.face, expected.column, expected.row),
                     .got = cell_words(answer[0], answer[1], answer[2])};
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (goes_through(given, answer[0], answer[1], answer[2]))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const LightCell cell = found_cell(given);
    const Seen seen = seen_through(given.direction, cell.face);
    return fmt::format("direction   {}\nresolution  {}\nThe largest coordinate, sign aside, is {:.6g}; the two "
                       "after it, over that, are {:.6g} and {:.6g}: from -1 to 1 across the face.",
                       words(given.direction), given.resolution, static_cast<double>(seen.w),
                       static_cast<double>(seen.u / seen.w), static_cast<double>(seen.v / seen.w));
}

// The cube unfolded: -z in the middle of a cross, seen from inside.
constexpr int side = 56, picture_width = 4 * side, picture_height = 3 * side, picture_resolution = 7;

std::optional<Vec3d> direction_at(int x, int y) {
    const int column = x / side, row = y / side;
    const double right = 2 * ((x + 0.5) / side - column) - 1, up = 1 - 2 * ((y + 0.5) / side - row);
    if (row == 0 && column == 1) return Vec3d{right, 1, up};
    if (row == 2 && column == 1) return Vec3d{right, -1, -up};
    if (row != 1) return std::nullopt;
    const std::array<Vec3d, 4> around{Vec3d{-1, up, -right}, Vec3d{right, up, -1}, Vec3d{1, up, right},
                                      Vec3d{-right, up, 1}};
    return around[static_cast<std::size_t>(column)];
}

std::vector<Case> pixel_cases(int x, int y) {
    return {make("", Case::Kind::graded, direction_at(x, y).value_or(Vec3d{1, 0, 0}), picture_resolution)};
}

// Each face has its hue; columns become lighter, and every other row is darker. Cells that do not exist are black.
Pixel shade(int x, int y, std::span<const double> answer) {
    constexpr std::array<Pixel, 6> hues{Pixel{0.8f, 0.3f, 0.1f}, {0.1f, 0.35f, 0.6f}, {0.8f, 0.6f, 0.1f},
                                        {0.1f, 0.5f, 0.35f},     {0.6f, 0.3f, 0.5f},  {0.45f, 0.45f, 0.45f}};
    if (!direction_at(x, y)) return {0.02f, 0.03f, 0.06f};
    for (std::size_t i = 0; i < 3; ++i)
        if (!(answer[i] >= 0 && answer[i] < (i == 0 ? 6 : picture_resolution))) return {0, 0, 0};
    const Pixel hue = hues[static_cast<std::size_t>(answer[0])];
    const double light = (0.35 + answer[1] / picture_resolution) * (std::fmod(std::floor(answer[2]), 2) == 0 ? 1 : 0.7);
    const auto lit = [&](float value) { return cast<float>(value * light); };
    return {lit(hue.r), lit(hue.g), lit(hue.b)};
}

}  // namespace

Exercise light_cell_exercise() {
    return exercise_on(
        light_cell_slot, answer,
        {.chart = "light_buffer",
         .inputs = inputs,
         .outputs = outputs,
         .arguments = {{Part::Kind::direction, "the direction", 3}, {Part::Kind::indices, "the resolution", 1}},
         .cases = cases,
         .judge = judge,
         .parts = {{Part::Kind::indices, "the face"}, {Part::Kind::indices, "column and row", 2}},
         .symptoms = symptoms(),
         .story = story,
         .sketch = sketch,
         .picture = {.about = "the cube unfolded, each cell in its colour",
                     .width = picture_width,
                     .height = picture_height,
                     .cases = pixel_cases,
                     .shade = shade}});
}

}  // namespace raylab::grading
