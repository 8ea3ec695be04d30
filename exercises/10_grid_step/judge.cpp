#include "10_grid_step/slot.h"
#include "arguments.h"
#include "boundary.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "walk.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace grid_step;

constexpr double margin = 0.01;  // in sides of a cell, between a graded ray and a cell's edge

Case make(const std::string& group, Case::Kind kind, const Arguments& given) { return {group, kind, as_input(given)}; }

// A cell of a grid, a point in it, and a ray to this point that begins `before` lengths of its direction away.
struct Stage {
    Arguments given;
    double t;  // of the point in the cell
};

Stage stage(Dice& dice, Vec3d direction, double scale = 1) {
    const UniformGrid grid{dice.point(-9, 9) * scale,
                           dice.in(0.3, 2) * scale,
                           {whole(dice, 3, 40), whole(dice, 3, 40), whole(dice, 3, 40)}};
    Cell cell{};
    Vec3d point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        cell[axis] = whole(dice, 1, grid.cells[axis] - 2);
        point[i] = grid.low[i] + (cell[axis] + dice.in(0.1, 0.9)) * grid.side;
    }
    direction = direction * (dice.in(0.2, 5) * scale);
    const double before = dice.in(0, 1) < 0.3 ? 0 : dice.in(0, 30);
    return {{{point - direction * before, direction, {0, endless}}, grid, cell}, before};
}

Vec3d with_signs(Dice& dice, double sign) {
    const Vec3d d = dice.direction();
    return Vec3d{std::abs(d.x), std::abs(d.y), std::abs(d.z)} * sign;
}

Case forward(Dice& dice) {
    return make("rays that go up every axis", Case::Kind::graded, stage(dice, with_signs(dice, 1)).given);
}
Case backward(Dice& dice) {
    return make("rays that go down every axis", Case::Kind::graded, stage(dice, with_signs(dice, -1)).given);
}
Case anywhere(Dice& dice) {
    return make("rays that go anywhere", Case::Kind::graded, stage(dice, dice.direction()).given);
}

Case along_axes(Dice& dice) {
    Vec3d direction = dice.direction();
    const int zeros = whole(dice, 1, 2), first = whole(dice, 0, 2);
    for (int k = 0; k < zeros; ++k) direction[(first + k) % 3] = dice.in(0, 1) < 0.5 ? 0.0 : -0.0;
    return make("rays at right angles to an axis", Case::Kind::graded, stage(dice, glm::normalize(direction)).given);
}

Case at_border(Dice& dice) {
    auto [given, t] = stage(dice, dice.direction());
    const auto exit = exit_of(given);
    Vec3d moved{0, 0, 0};
    const int last = exit->side > 0 ? given.grid.cells[exit->axis] - 1 : 0;
    moved[static_cast<int>(exit->axis)] = (last - given.cell[exit->axis]) * given.grid.side;
    given.cell[exit->axis] = last;
    given.ray.origin = given.ray.origin + moved;
    return make("rays that leave the grid", Case::Kind::graded, given);
}

Case near_border(Dice& dice) {  // in a border cell, but parallel to the border
    auto [given, t] = stage(dice, dice.direction());
    const auto exit = exit_of(given);
    const std::size_t axis = (exit->axis + 1) % 3;
    const int last = given.ray.direction[static_cast<int>(axis)] > 0 ? given.grid.cells[axis] - 1 : 0;
    given.ray.origin[static_cast<int>(axis)] += (last - given.cell[axis]) * given.grid.side;
    given.cell[axis] = last;
    return make("rays along the grid's border", Case::Kind::graded, given);
}

Case ends(Dice& dice) {
    auto [given, t] = stage(dice, dice.direction());
    const auto leave = static_cast<double>(exit_of(given)->t);
    const bool before = dice.in(0, 1) < 0.6;
    given.ray.range.max = before ? t + (leave - t) * dice.in(0.1, 0.9) : leave + (leave - t) * dice.in(0.1, 2) + 1e-3;
    return make(before ? "rays that end in the cell" : "rays that end further on", Case::Kind::graded, given);
}

// A little of t is much of a long direction.
Case ends_of_long_ones(Dice& dice) {
    Case question = ends(dice);
    Arguments given = arguments(question.input);
    given.ray.direction *= 0x1p30;
    given.ray.range.max *= 0x1p-30;
    return make(question.group, Case::Kind::graded, given);
}

Case of_any_size(Dice& dice) {
    const double scale = dice.in(0, 1) < 0.5 ? 1e-6 : 1e6;
    return make("grids of a micrometre, and of a thousand kilometres", Case::Kind::graded,
                stage(dice, dice.direction(), scale).given);
}

Case of_any_length(Dice& dice) {
    auto [given, t] = stage(dice, dice.direction());
    given.ray.direction *= heads(dice) ? 1e-12 : 1e12;
    return make("directions of any length", Case::Kind::graded, given);
}

// A ray through a cell, and then another ray through the cell that comes next: what was computed for the first one is
// of no use to it.
std::array<Case, 2> two_rays(Dice& dice) {
    for (;;) {
        const Arguments one = stage(dice, dice.direction()).given;
        Arguments other{{one.ray.origin, {}, one.ray.range}, one.grid, *truth(one)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const double inside = one.grid.low[i] + (other.cell[axis] + dice.in(0.1, 0.9)) * one.grid.side;
            other.ray.direction[i] = sign(dice) * dice.in(0.1, 1);
            other.ray.origin[i] = inside - other.ray.direction[i] * one.grid.side;
        }
        if (std::min(exit_of(one)->margin, exit_of(other)->margin) < margin) continue;
        const std::string group = "one ray after another, through the cell that was next";
        return {make(group, Case::Kind::graded, one), make(group, Case::Kind::graded, other)};
    }
}

Case through_edge(Dice& dice) {  // as exactly as doubles permit
    auto [given, t] = stage(dice, dice.direction());
    Vec3d corner{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<int>(axis);
        const double share = axis == 2 ? dice.in(0.1, 0.9) : given.ray.direction[i] > 0 ? 1.0 : 0.0;
        corner[i] = given.grid.low[i] + (given.cell[axis] + share) * given.grid.side;
    }
    given.ray.origin = corner - given.ray.direction * (t + 1) + dice.point(-1e-13, 1e-13);
    return make("rays through an edge", Case::Kind::adversarial, given);
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            const auto exit = exit_of(arguments(question.input));
            if (question.kind == Case::Kind::graded && (!exit || exit->margin < margin)) continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    add(30, forward);
    add(40, backward);
    add(40, anywhere);
    add(40, along_axes);
    add(40, at_border);
    add(30, near_border);
    add(40, ends);
    add(20, of_any_size);
    add(20, of_any_length);
    for (int i = 0; i < 15; ++i) std::ranges::move(two_rays(dice), std::back_inserter(all));
    for (int i = 0; i < 30; ++i)
        all.push_back(
            make("through an edge or a corner, in whole numbers", Case::Kind::graded, exactly_through_edge(dice)));
    for (int i = 0; i < 20; ++i)
        all.push_back(make("rays that end on the face, in whole numbers", Case::Kind::graded, ends_on_face(dice)));
    add(20, ends_of_long_ones);
    add(30, through_edge);
    return all;
}

std::string in_words(const std::optional<Cell>& cell) {
    return cell ? fmt::format("cell ({}, {}, {})", (*cell)[0], (*cell)[1], (*cell)[2]) : "no next cell";
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto expected = truth(arguments(question.input));
    Judgement result{.expected = in_words(expected), .got = "no number"};
    const auto is_place = [](double x) { return std::isfinite(x) && std::abs(x) < 1e9; };
    if (!std::ranges::all_of(answer, is_place)) {
        result.outcome = Judgement::Outcome::nonfinite;
        return result;
    }
    const Cell cell{static_cast<int>(answer[1]), static_cast<int>(answer[2]), static_cast<int>(answer[3])};
    const std::optional<Cell> got = answer[0] != 0 ? std::optional(cell) : std::nullopt;
    result.got = in_words(got);
    if (is_next(arguments(question.input), got)) result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const auto exit = exit_of(given);
    return fmt::format("origin     {}\ndirection  {}, t up to {}\ngrid       from {}, cells of {:.4g}, {} x {} x {} "
                       "of them\nin         {}\nThe ray leaves this cell through its {} face of axis {}, at t = "
                       "{:.6g}.",
                       words(given.ray.origin), words(given.ray.direction), words(given.ray.range.max),
                       words(given.grid.low), given.grid.side, given.grid.cells[0], given.grid.cells[1],
                       given.grid.cells[2], in_words(given.cell), exit->side > 0 ? "upper" : "lower", exit->axis,
                       static_cast<double>(exit->t));
}

std::vector<Case> pixel_cases(int x, int y) { return {make("", Case::Kind::graded, looking(x, y))}; }

Pixel shade(int x, int y, std::span<const double> answer) {
    const Arguments given = looking(x, y);
    if (answer[0] == 0 || !std::ranges::all_of(answer, [](double v) { return std::isfinite(v); }))
        return {0.02f, 0.03f, 0.06f};
    const Vec3d step{answer[1] - given.cell[0], answer[2] - given.cell[1], answer[3] - given.cell[2]};
    const Vec3d color = Vec3d{0.45, 0.45, 0.45} + step * 0.35;  // x: red, y: green, z: blue; up: light, down: dark
    const double far = 1 / (1 + 0.5 * static_cast<double>(exit_of(given)->t));
    const auto lit = [&](double c) { return cast<float>(std::clamp(c, 0.0, 1.0) * far); };
    return {lit(color.x), lit(color.y), lit(color.z)};
}

}  // namespace

Exercise grid_step_exercise() {
    return exercise_on(next_cell_slot, answer,
                       {.chart = "grid_walk",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::vector, "the origin", 3},
                                      {Part::Kind::direction, "the direction", 3},
                                      {Part::Kind::number, "range.max"},
                                      {Part::Kind::vector, "the grid's low corner", 3},
                                      {Part::Kind::number, "the side"},
                                      {Part::Kind::indices, "cells", 3},
                                      {Part::Kind::indices, "cell", 3}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::flag, "a next cell"}, {Part::Kind::indices, "the cell", 3}},
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a cell from inside: which wall each ray leaves through",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade},
                        .work = work_tasks()});
}

}  // namespace raylab::grading
