#include "08b_light_list/slot.h"
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

using namespace light_list;

constexpr double tolerance = 1e-12;  // of a share, of which the least that is not 0 is about 1e-8

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&)) {
        for (int i = 0; i < count; ++i) all.push_back({group, Case::Kind::graded, as_input(next(dice))});
    };
    add(30, "the way misses all entries", nothing_in_the_way);
    add(40, "something opaque in the way", something_opaque);
    add(40, "panes of glass in the way", panes);
    add(40, "glass, and something opaque behind it", glass_then_opaque);
    add(40, "the list goes on beyond the point", list_goes_on);
    add(30, "behind what fills the cell", behind_what_fills);
    add(20, "before what fills the cell", before_what_fills);
    add(20, "on what fills the cell", on_what_fills);
    add(20, "an entry begins as deep as the point", as_deep_as_an_entry);
    add(10, "an empty list", empty_list);
    add(10, "an empty list, behind what fills the cell", empty_and_filled);
    add(30, "hardly any light", hardly_any_light);
    add(15, "all entries begin equally deep", equally_deep);
    add(15, "hardly before an entry", hardly_before_an_entry);
    add(15, "hardly behind what fills the cell", hardly_behind_what_fills);
    return all;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto given = of(question);
    const double expected = truth(given);
    Judgement result{.expected = words(expected), .got = words(answer[0]) + fmt::format(", by {:g} tests", answer[1])};
    if (!std::isfinite(answer[0]) || !std::isfinite(answer[1])) {
        result.outcome = Judgement::Outcome::nonfinite;
        return result;
    }
    if (const auto wasted = first_wasted(given, asked_of(answer))) {
        result.expected += ", and no test in vain";
        result.got += ": " + in_words(*wasted);
        return result;
    }
    if (std::abs(answer[0] - expected) <= tolerance) result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = of(question);
    std::string text =
        fmt::format("depth    {}\nfilled   {}\nentries  {}", words(given.depth), words(given.filled), given.count());
    for (int i = 0; i < given.count(); ++i) {
        const auto [begin, share] = *given.entry(i);
        text += fmt::format("\n  {}      begins at {}, {}{}", i, words(begin),
                            share == 1   ? "missed"
                            : share == 0 ? "opaque"
                                         : fmt::format("lets {:.6g} through", share),
                            begin > given.depth ? " (deeper than the point)" : "");
    }
    if (is_behind_what_fills(given)) text += "\nThe point is behind what fills the cell.";
    return text;
}

}  // namespace

Exercise light_list_exercise() {
    return exercise_on(light_through_list_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a floor under two panes, a plate and a board, from above, the redder the "
                                             "more your function tests",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
