#include "13_drawn_depth/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "questions.h"
#include "sketch.h"
#include "symptoms.h"
#include "words.h"

#include <cmath>

namespace raylab::grading {

namespace {

using namespace drawing_depth;

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&),
                         Case::Kind kind = Case::Kind::graded) {
        for (int i = 0; i < count; ++i) all.push_back({group, kind, as_input(next(dice))});
    };
    add(20, "all corners in one depth", facing);
    add(40, "slanted", slanted);
    add(30, "slanted, and running far off", far_away);
    add(30, "beside the triangle", outside);
    add(20, "beside the triangle, in the rectangle about it", hardly_outside);
    add(30, "in other units", other_units);
    add(30, "on an edge, in whole numbers", on_an_edge);
    add(20, "at a corner, in whole numbers", at_a_corner);
    add(20, "beyond an edge on its line, in whole numbers", beyond_an_edge);
    add(20, "seen edge-on, in whole numbers", edge_on);
    add(20, "within rounding of an edge", hardly_on_an_edge, Case::Kind::adversarial);
    return all;
}

std::string in_words(const std::optional<double>& depth) {
    return depth ? fmt::format("depth {}", words(*depth)) : "not covered";
}

std::optional<double> said(std::span<const double> answer) {
    return answer[0] == 1 ? std::optional(answer[1]) : std::nullopt;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto expected = truth(arguments(question.input)), given = said(answer);
    Judgement result{.expected = in_words(expected), .got = in_words(given)};
    if (!std::isfinite(answer[0]) || !std::isfinite(answer[1]))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (expected.has_value() == given.has_value() && (!expected || is_same(*expected, *given)))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    std::string text;
    for (const auto& [x, y, depth] : given.corners)
        text += fmt::format("corner  ({}, {}), depth {}\n", words(x), words(y), words(depth));
    text += fmt::format("place   ({}, {})\n", words(given.x), words(given.y));
    const auto share = picture_weights(given);
    if (!std::isfinite(share[0])) return text + "The three corners are drawn on one line.";
    return text + fmt::format("In the picture the corners have the shares {:.6g}, {:.6g} and {:.6g} at this place.",
                              static_cast<double>(share[0]), static_cast<double>(share[1]),
                              static_cast<double>(share[2]));
}

}  // namespace

Exercise drawn_depth_exercise() {
    return exercise_on(
        drawn_depth_slot, answer,
        {.chart = "first_hit",
         .inputs = inputs,
         .outputs = outputs,
         .arguments = {{Part::Kind::number, "a corner's x"},
                       {Part::Kind::number, "a corner's y"},
                       {Part::Kind::number, "a corner's depth"},
                       {Part::Kind::number, "a corner's x"},
                       {Part::Kind::number, "a corner's y"},
                       {Part::Kind::number, "a corner's depth"},
                       {Part::Kind::number, "a corner's x"},
                       {Part::Kind::number, "a corner's y"},
                       {Part::Kind::number, "a corner's depth"},
                       {Part::Kind::number, "x"},
                       {Part::Kind::number, "y"}},
         .cases = cases,
         .judge = judge,
         .parts = {{Part::Kind::flag, "whether the place is covered"}, {Part::Kind::number, "the depth"}},
         .symptoms = symptoms(),
         .story = story,
         .sketch = sketch,
         .picture = {.about = "four triangles, each with a stripe at every unit of depth",
                     .width = picture_width,
                     .height = picture_height,
                     .cases = pixel_cases,
                     .shade = shade}});
}

}  // namespace raylab::grading
