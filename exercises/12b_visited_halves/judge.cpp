#include "12b_visited_halves/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "questions.h"
#include "sketch.h"
#include "symptoms.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace halves;

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&),
                         Case::Kind kind = Case::Kind::graded) {
        for (int i = 0; i < count; ++i) all.push_back({group, kind, as_input(next(dice))});
    };
    add(40, "up through the plane", rising);
    add(40, "down through the plane", falling);
    add(30, "the plane lies beyond the range", beyond);
    add(30, "the plane lies before the range", before);
    add(30, "a range that begins before the start, and so does the plane", before_the_start);
    add(30, "a range without end", without_end);
    add(20, "long and short directions", any_length);
    add(30, "parallel to the plane, beside it", parallel);
    add(20, "in the plane, in whole numbers", in_the_plane);
    add(30, "the range begins or ends at the plane, in whole numbers", touching_the_plane);
    add(20, "from a point of the plane, in whole numbers", from_the_plane);
    add(30, "within rounding of the range's ends", hardly_touching, Case::Kind::adversarial);
    return all;
}

std::string in_words(std::span<const double> answer) {
    std::string text;
    for (const auto& [half, range] : read_halves(answer))
        text += fmt::format("{}the half {} from {} to {}", text.empty() ? "" : ", then ",
                            half == CellHalf::below ? "below" : "above", words(range.min), words(range.max));
    if (answer[0] > 2) text += fmt::format(", and {} more", answer[0] - 2);
    return text.empty() ? "neither half" : text;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto given = arguments(question.input);
    std::array<double, outputs> expected{};
    write_halves(truth(given), expected);
    Judgement result{.expected = in_words(expected), .got = in_words(answer)};
    if (std::ranges::any_of(answer, [](double x) { return std::isnan(x); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (is_right(given, answer))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    const std::string where =
        given.direction == 0
            ? fmt::format("The ray is parallel to the plane, {}.", given.origin == given.plane  ? "and in it"
                                                                   : given.origin < given.plane ? "below it"
                                                                                                : "above it")
            : fmt::format("The ray reaches the plane at t = {}.", words(static_cast<double>(crossing(given))));
    return fmt::format("origin     {}\ndirection  {}\nplane      {}\nrange      {} to {}\n{}", words(given.origin),
                       words(given.direction), words(given.plane), words(given.range.min), words(given.range.max),
                       where);
}

}  // namespace

Exercise visited_halves_exercise() {
    return exercise_on(visited_halves_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::number, "the origin"},
                                      {Part::Kind::number, "the direction"},
                                      {Part::Kind::number, "the plane"},
                                      {Part::Kind::number, "range.min"},
                                      {Part::Kind::number, "range.max"}},
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a room with three panes of glass, which tint what is behind them where "
                                             "both halves are visited",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
