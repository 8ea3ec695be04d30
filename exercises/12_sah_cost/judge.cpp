#include "12_sah_cost/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "walk.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace cuts;

constexpr double tolerance = 1e-9;  // relative

Case make(const std::string& group, Case::Kind kind, const SahCut& cut) { return {group, kind, as_input(cut)}; }

double whole(Dice& dice, double low, double high) { return std::round(dice.in(low, high)); }

// A cut in which no two sides are equal, the plane is not in the middle, both sides have primitives, and the costs have
// any size.
SahCut any_cut(Dice& dice, double scale) {
    SahCut cut{};
    cut.size = dice.point(1, 4) * scale;
    cut.axis = static_cast<int>(dice.in(0, 3));
    cut.place = cut.size[cut.axis] * (dice.in(0, 1) < 0.5 ? dice.in(0.1, 0.4) : dice.in(0.6, 0.9));
    cut.below = whole(dice, 1, 20);
    cut.above = whole(dice, 21, 60);
    cut.visit_cost = dice.in(0.5, 3);
    cut.test_cost = dice.in(1, 5);
    cut.empty_bonus = dice.in(0.1, 0.8);
    return cut;
}

Case cube(Dice& dice) {
    SahCut cut = any_cut(dice, 1);
    cut.size = Vec3d(whole(dice, 1, 5));
    cut.place = cut.size.x / 2;
    return make("cubes, cut in the middle", Case::Kind::graded, cut);
}

Case any_cell(Dice& dice) { return make("any cell, any plane", Case::Kind::graded, any_cut(dice, 1)); }

Case free_visit(Dice& dice) {
    SahCut cut = any_cut(dice, 1);
    cut.visit_cost = 0;
    return make("visits that cost nothing", Case::Kind::graded, cut);
}

Case below_empty(Dice& dice) {
    SahCut cut = any_cut(dice, 1);
    cut.below = 0;
    return make("nothing below", Case::Kind::graded, cut);
}

Case above_empty(Dice& dice) {
    SahCut cut = any_cut(dice, 1);
    cut.above = 0;
    return make("nothing above", Case::Kind::graded, cut);
}

Case at_an_end(Dice& dice) {
    SahCut cut = any_cut(dice, 1);
    cut.place = dice.in(0, 1) < 0.5 ? 0 : cut.size[cut.axis];
    return make("a plane that is a side of the cell", Case::Kind::graded, cut);
}

// A cell without height still has an area: that of its two sides.
Case flat(Dice& dice) {
    SahCut cut = any_cut(dice, 1);
    const int thin = static_cast<int>(dice.in(0, 3));
    cut.size[thin] = 0;
    cut.place = std::min(cut.place, cut.size[cut.axis]);
    return make("flat cells", Case::Kind::graded, cut);
}

Case line(Dice& dice) {
    SahCut cut = any_cut(dice, 1);
    const int left = static_cast<int>(dice.in(0, 4));  // 3: a point
    for (int axis = 0; axis < 3; ++axis)
        if (axis != left) cut.size[axis] = 0;
    cut.place = cut.size[cut.axis] / 4;
    return make("cells without any area", Case::Kind::graded, cut);
}

Case scaled(Dice& dice) {
    return make("kilometres and thousandths of a millimetre", Case::Kind::graded,
                any_cut(dice, std::pow(10, dice.in(-6, 4))));
}

Case extreme(Dice& dice) {
    return make("cells whose area no double can hold", Case::Kind::adversarial,
                any_cut(dice, dice.in(0, 1) < 0.5 ? 1e-170 : 1e170));
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(20, cube);
    add(50, any_cell);
    add(20, free_visit);
    add(30, below_empty);
    add(30, above_empty);
    add(20, at_an_end);
    add(30, flat);
    add(20, line);
    add(30, scaled);
    add(20, extreme);
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto expected = static_cast<double>(truth(arguments(question.input)).cost);
    Judgement result{.expected = words(expected), .got = words(answer[0])};
    if (std::isinf(expected) ? answer[0] == expected : std::abs(answer[0] - expected) <= tolerance * expected)
        result.outcome = Judgement::Outcome::right;
    else if (!std::isfinite(answer[0]))
        result.outcome = Judgement::Outcome::nonfinite;
    return result;
}

std::string story(const Case& question) {
    const SahCut cut = arguments(question.input);
    const Truth found = truth(cut);
    return fmt::format("size         {}\nplane        across {} at {:.6g} of {:.6g}\nthings       {} below, {} "
                       "above\nvisit_cost   {:.6g}\ntest_cost    {:.6g}\nempty_bonus  {:.6g}\n",
                       words(cut.size), "xyz"[cut.axis], cut.place, cut.size[cut.axis], cut.below, cut.above,
                       cut.visit_cost, cut.test_cost, cut.empty_bonus) +
           (std::isinf(found.cost)
                ? "The cell has no area at all."
                : fmt::format("A ray that hits the cell hits the lower half with a probability of {:.6g}, the upper "
                              "one of {:.6g}.",
                              static_cast<double>(found.hits_below), static_cast<double>(found.hits_above)));
}

// A cell 3 x 2 x 1 with thirty primitives: the place of the plane from left to right, and from top to bottom how many
// of them lie below it.
constexpr int picture_width = 240, picture_height = 124;
constexpr double things = 30;

std::vector<Case> pixel_cases(int x, int y) {
    const double below = std::floor(things * y / (picture_height - 1) + 0.5);
    return {
        make("", Case::Kind::graded, {{3, 2, 1}, 0, 3 * (x + 0.5) / picture_width, below, things - below, 1, 1, 0.3})};
}

// Green where a cut costs less than no cut, the greener the less it costs; otherwise red.
Pixel shade(int, int, std::span<const double> answer) {
    if (!std::isfinite(answer[0])) return {0.02f, 0.03f, 0.06f};
    const double saved = std::clamp((things - answer[0]) / things, -1.0, 1.0);
    const double steps = std::floor(std::abs(saved) * 12) / 12;
    const auto strong = cast<float>(0.08 + 0.85 * steps);
    return saved >= 0 ? Pixel{0.08f, strong, 0.3f * strong} : Pixel{strong, 0.08f, 0.08f};
}

}  // namespace

Exercise sah_cost_exercise() {
    return exercise_on(sah_cost_slot, answer,
                       {.chart = "split_tree",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::vector, "the size", 3},
                                      {Part::Kind::indices, "the axis", 1},
                                      {Part::Kind::number, "the place"},
                                      {Part::Kind::number, "how many are below"},
                                      {Part::Kind::number, "how many are above"},
                                      {Part::Kind::number, "visit_cost"},
                                      {Part::Kind::number, "test_cost"},
                                      {Part::Kind::number, "empty_bonus"}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::number, "the cost"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "what cuts of one cell save (green), plane by plane and share by share",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade},
                        .work = work_tasks()});
}

}  // namespace raylab::grading
