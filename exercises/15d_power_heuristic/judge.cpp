#include "15d_power_heuristic/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "flat_view.h"
#include "known.h"
#include "one_number.h"
#include "picture.h"
#include "symptoms.h"
#include "words.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::grading {

namespace {

using namespace heuristic;

constexpr double tolerance = 1e-12;  // of a weight, which is at most 1: a thousand roundings
constexpr double unbounded = std::numeric_limits<double>::infinity();

Case densities(const std::string& group, double pdf, double other, Case::Kind kind = Case::Kind::graded) {
    return {group, kind, {pdf, other}};
}

double any_density(Dice& dice) { return std::pow(10, dice.in(-3, 4)); }

// Densities whose weights are neither near 0 nor near 1.
Case alike(Dice& dice) {
    const double pdf = any_density(dice);
    return densities("densities of one size", pdf, pdf * dice.in(0.2, 5));
}

Case far_apart(Dice& dice) { return densities("densities of different sizes", any_density(dice), any_density(dice)); }

Case equal(Dice& dice) {
    const double pdf = any_density(dice);
    return densities("equal densities", pdf, pdf);
}

Case only_one(Dice& dice) { return densities("the other strategy never chooses it", any_density(dice), 0); }

// Where the square of a density leaves the doubles, though the density itself does not.
Case tiny_light(Dice& dice) {
    const double pdf = std::pow(10, dice.in(160, 300));
    return densities("densities up to 10^300, of a tiny light", pdf, pdf * dice.in(0.2, 5));
}

Case wide_lobe(Dice& dice) {
    const double pdf = std::pow(10, dice.in(-300, -170));
    return densities("densities down to 10^-300", pdf, pdf * dice.in(0.2, 5));
}

Case one_is_infinite(Dice& dice) {
    const double pdf = any_density(dice);
    return dice.in(0, 1) < 0.5 ? densities("an infinite density, of a point or a mirror", unbounded, pdf)
                               : densities("an infinite density, of a point or a mirror", pdf, unbounded);
}

// Quotients of these leave the doubles, too.
Case out_of_reach(Dice& dice) {
    const double large = std::pow(10, dice.in(200, 300)), small = std::pow(10, dice.in(-320, -200));
    return dice.in(0, 1) < 0.5 ? densities("10^200 beside 10^-200", large, small, Case::Kind::adversarial)
                               : densities("10^200 beside 10^-200", small, large, Case::Kind::adversarial);
}

std::vector<Case> heuristic_cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(80, alike);
    add(40, far_apart);
    add(20, equal);
    add(20, only_one);
    add(30, tiny_light);
    add(30, wide_lobe);
    add(20, one_is_infinite);
    add(20, out_of_reach);
    return all;
}

// By the ratio in long doubles, whose exponents reach to 10^4932: neither ratio nor square can leave them.
double right_weight(double pdf, double other) {
    if (std::isinf(pdf)) return 1;
    const long double ratio = static_cast<long double>(other) / static_cast<long double>(pdf);
    return static_cast<double>(1 / (1 + ratio * ratio));
}

Judgement judge_heuristic(const Case& question, std::span<const double> answer) {
    return judged_number(right_weight(question.input[0], question.input[1]), answer[0], tolerance);
}

std::string heuristic_story(const Case& question) {
    const double pdf = question.input[0], other = question.input[1];
    return fmt::format("pdf        {}\nother      {}\nThe strategy that chose the direction does so {} as often as the "
                       "other one would.",
                       words(pdf), words(other),
                       other == 0 || std::isinf(pdf) ? "infinitely" : words(pdf / other) + " times");
}

// The weight over the share that the strategy has of both densities: a curve from 0 to 1, steep in its middle.
PlaneDrawing heuristic_sketch(const Case& question, std::span<const double> answer) {
    const double pdf = question.input[0], other = question.input[1];
    // By the other's ratio, since a sum of both may leave the doubles.
    const double share = std::isinf(pdf) ? 1 : std::isinf(other) ? 0 : 1 / (1 + other / pdf);
    const double right = right_weight(pdf, other);
    PlaneDrawing drawing{.title = "the weight (upward) over the strategy's share of both densities (to the right)",
                         .low = {-0.3, -0.35},
                         .high = {1.6, 1.5},
                         .notes = {"green: right; red: yours"}};
    const auto mark = [&](PlaneDrawing::Mark added) { drawing.marks.push_back(std::move(added)); };
    std::vector<PlanePoint> curve;
    for (int i = 0; i <= 60; ++i) {
        const double x = i / 60.0;
        curve.push_back({x, x * x / (x * x + (1 - x) * (1 - x))});
    }
    mark(PlaneDrawing::Path{{{0, 1}, {0, 0}, {1, 0}}, {.line = case_ink::given, .width = 1.5}});
    mark(PlaneDrawing::Path{curve, {.line = case_ink::faint, .width = 2}});
    const auto dot = [&](double value, const char* color, const std::string& whose, double aside) {
        const bool is_number = std::isfinite(value);
        const double shown = is_number ? std::clamp(value, -0.3, 1.4) : -0.3;
        if (is_number) mark(PlaneDrawing::Dot{{share, shown}, 6, color});
        mark(PlaneDrawing::Text{.at = {share + 0.03, shown + aside},
                                .words = whose + (is_number ? fmt::format(": {:.6g}", value) : ": no number"),
                                .color = color,
                                .halo = "#ffffff"});
    };
    dot(right, case_ink::right, "right", 0.04);
    dot(answer[0], case_ink::yours, "yours", -0.06);
    return drawing;
}

}  // namespace

Exercise power_heuristic_exercise() {
    return exercise_on(power_heuristic_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::number, "the density of the strategy that chose"},
                                      {Part::Kind::number, "the other density"}},
                        .cases = heuristic_cases,
                        .judge = judge_heuristic,
                        .parts = {{Part::Kind::number, "the weight"}},
                        .symptoms = symptoms(),
                        .story = heuristic_story,
                        .sketch = heuristic_sketch,
                        .picture = heuristic_picture()});
}

}  // namespace raylab::grading
