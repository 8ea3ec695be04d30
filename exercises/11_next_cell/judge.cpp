#include "11_next_cell/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "walk.h"
#include "whole_numbers.h"
#include "words.h"

#include <algorithm>

namespace raylab::grading {

namespace {

using namespace next_cell;

constexpr double min_margin = 0.02;  // of the smallest cell: cases nearer to an edge or a side are adversarial

// A cube, 2^level smallest cells wide, somewhere among cells that begin at multiples of their sides.
OctreeCube some_cube(Dice& dice, double smallest, int level) {
    const double side = std::ldexp(smallest, level);
    const auto at = [&] { return side * std::floor(dice.in(-8, 8)); };
    const double x = at(), y = at();
    return {{x, y, at()}, side};
}

// A ray through a point well inside the cube, which begins at this distance before it.
Case through(const std::string& group, const OctreeCube& cube, double smallest, const Vec3d& inside,
             const Vec3d& direction, double before) {
    const Vec3d origin = cube.low + cube.side * inside - (before * cube.side) * direction;
    return {group, Case::Kind::graded, as_input({cube, smallest, origin, direction})};
}

Case forward(Dice& dice) {
    const Vec3d d = dice.point(0.1, 1);
    return through("forward along all axes", some_cube(dice, 1, 2), 1, dice.point(0.1, 0.9), d, dice.in(0, 3));
}

Case any_way(Dice& dice) {
    return through("in any direction", some_cube(dice, 1, 2), 1, dice.point(0.1, 0.9), dice.direction(), dice.in(0, 3));
}

Case among_smallest(Dice& dice) {
    return through("the smallest cells", some_cube(dice, 0.5, 0), 0.5, dice.point(0.1, 0.9), dice.direction(),
                   dice.in(0, 3));
}

Case beside_smallest(Dice& dice) {
    return through("large cells, small ones beside them", some_cube(dice, 0.25, 5), 0.25, dice.point(0.1, 0.9),
                   dice.direction(), dice.in(0, 2));
}

Case any_length(Dice& dice) {
    const Vec3d d = dice.direction() * std::exp(dice.in(-5, 5));
    return through("directions of any length", some_cube(dice, 1, 2), 1, dice.point(0.1, 0.9), d, dice.in(0, 0.5));
}

Case very_short_or_long(Dice& dice) {
    const Vec3d d = dice.direction() * (heads(dice) ? 1e-9 : 1e9);
    return through("directions of a billionth, and of a billion", some_cube(dice, 1, 2), 1, dice.point(0.1, 0.9), d, 0);
}

Case along_plane(Dice& dice) {
    Vec3d d = dice.direction();
    d[static_cast<int>(dice.in(0, 3))] = 0;
    return through("one axis unchanged", some_cube(dice, 1, 2), 1, dice.point(0.1, 0.9), d, dice.in(0, 3));
}

Case along_axis(Dice& dice) {
    Vec3d d{0, 0, 0};
    d[static_cast<int>(dice.in(0, 3))] = dice.in(0, 1) < 0.5 ? -1 : 1;
    return through("along an axis", some_cube(dice, 1, 2), 1, dice.point(0.1, 0.9), d, dice.in(0, 3));
}

Case other_scale(Dice& dice, const std::string& group, double smallest) {
    return through(group, some_cube(dice, smallest, 2), smallest, dice.point(0.1, 0.9), dice.direction(),
                   dice.in(0, 3));
}

Case microscopic(Dice& dice) { return other_scale(dice, "cells of a millionth", 0x1p-20); }
Case huge(Dice& dice) { return other_scale(dice, "cells of a million", 0x1p20); }

// A ray that leaves through an edge, exactly or nearly.
Case at_edge(Dice& dice) {
    const OctreeCube cube = some_cube(dice, 1, 2);
    const double off = std::ldexp(dice.in(-1, 1), -30);
    Case question = through("out by an edge", cube, 1, {0.5, 0.5 + off, 0.4}, {1, 1, dice.in(-0.3, 0.3)}, 1);
    question.kind = Case::Kind::adversarial;
    return question;
}

// A ray in the plane between two rows of smallest cells, or in a side of the cube: it may go on in either row.
Case on_border(Dice& dice) {
    const OctreeCube cube = some_cube(dice, 1, 2);
    const int axis = whole(dice, 0, 2);
    Vec3d inside{0.375, 0.375, 0.375};
    inside[(axis + whole(dice, 1, 2)) % 3] = whole(dice, 0, 4) / 4.0;
    return through("along a border between cells, in whole numbers", cube, 1, inside,
                   along(axis, sign(dice) * power_of_two(dice, -2, 2)), whole(dice, 0, 2));
}

// Out through a face, near the side of a smallest cell beside it, to which the ray goes on: rounding is a thousand
// millionth of what is left there, and a step along the ray is too far.
Case near_a_side(Dice& dice) {
    const OctreeCube cube = some_cube(dice, 1, 2);
    const int axis = whole(dice, 0, 2), aside = (axis + whole(dice, 1, 2)) % 3, rest = 3 - axis - aside;
    Vec3d way = along(axis, sign(dice)), exit{};
    way[aside] = sign(dice) * dice.in(0.3, 0.9);
    way[rest] = dice.in(-0.3, 0.3);
    exit[axis] = way[axis] > 0 ? 1 : 0;
    exit[aside] = (whole(dice, 1, 3) - std::copysign(std::pow(10, -dice.in(3.5, 5)), way[aside])) / 4;
    exit[rest] = (whole(dice, 1, 2) + dice.in(0.3, 0.7)) / 4;
    return through("near the side of a smallest cell", cube, 1, exit - 0.1 * way, way, dice.in(0, 1));
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            if (question.kind == Case::Kind::graded && truth(arguments(question.input)).margin < min_margin) continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    for (const auto& group : {forward, any_way, among_smallest, beside_smallest, any_length, along_plane, along_axis,
                              microscopic, huge, at_edge})
        add(30, group);
    for (int i = 0; i < 30; ++i) all.push_back(on_border(dice));
    for (int i = 0; i < 20; ++i) all.push_back(near_a_side(dice));
    add(20, very_short_or_long);
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const Arguments given = arguments(question.input);
    const Truth true_cell = truth(given);
    const Vec3d low{true_cell.low[0], true_cell.low[1], true_cell.low[2]};
    Judgement result{.expected = "a point between " + words(low) + " and " + words(low + Vec3d(given.smallest)),
                     .got = words(Vec3d{answer[0], answer[1], answer[2]})};
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (is_right(given, true_cell, answer))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const Arguments given = arguments(question.input);
    const int axis = truth(given).axis;
    return fmt::format("cell       from {}, {} wide; the smallest are {} wide\nray        from {} along {}\nIt "
                       "leaves the cell across {} = {}, before it reaches the cell's other far sides.",
                       words(given.cube.low), words(given.cube.side), words(given.smallest), words(given.origin),
                       words(given.direction), "xyz"[axis],
                       words(given.cube.low[axis] + (given.direction[axis] > 0 ? given.cube.side : 0)));
}

}  // namespace

Exercise next_cell_exercise() {
    return exercise_on(point_in_next_cell_slot, answer,
                       {.chart = "octree_next_cell",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::vector, "the cube's low corner", 3},
                                      {Part::Kind::number, "the cube's side"},
                                      {Part::Kind::number, "the smallest side"},
                                      {Part::Kind::vector, "the origin", 3},
                                      {Part::Kind::direction, "the direction", 3}},
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = patchwork_picture(),
                        .work = work_tasks()});
}

}  // namespace raylab::grading
