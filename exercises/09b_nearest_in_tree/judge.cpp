#include "09b_nearest_in_tree/slot.h"
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

using namespace tree;

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&),
                         Case::Kind kind = Case::Kind::graded) {
        for (int i = 0; i < count; ++i) all.push_back({group, kind, as_input(next(dice))});
    };
    add(60, "rays from anywhere", anywhere);
    add(40, "the box that is entered first is empty", empty_first);
    add(40, "a nearer hit in a box that is entered later", overlapping);
    add(40, "one thing hides three others", hiding);
    add(30, "boxes are hit, and nothing in them", in_vain);
    add(30, "from inside the boxes", from_inside);
    add(20, "two leaves, or four", few_leaves);
    add(20, "past the root's box", beside_the_root);
    add(20, "the root is a leaf", single_leaf);
    add(20, "a short direction, and t in millions", far_away);
    add(20, "the same ball in two leaves, up to rounding", nearly_twice, Case::Kind::adversarial);
    return all;
}

std::string in_words(bool hit, double t, double asked) {
    return (hit ? "a hit at t = " + words(t) : "no hit") +
           fmt::format(", by {:g} question{}", asked, asked == 1 ? "" : "s");
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto given = arguments(question.input);
    const auto expected = truth(given);
    Judgement result{.expected = expected ? "a hit at t = " + words(*expected) : "no hit",
                     .got = in_words(answer[0] != 0, answer[1], answer[2])};
    if (!std::isfinite(answer[0]) || !std::isfinite(answer[1]) || !std::isfinite(answer[2])) {
        result.outcome = Judgement::Outcome::nonfinite;
        return result;
    }
    if (const auto wasted = first_wasted(given, asked_of(answer))) {
        result.expected += ", and no question in vain";
        result.got += ": " + in_words(given, *wasted);
        return result;
    }
    const DepthFirst search(given);
    if (!search.has_ties() && answer[2] > static_cast<double>(search.questions())) {
        result.expected +=
            fmt::format(", by {} question{} at most", search.questions(), search.questions() == 1 ? "" : "s");
        return result;
    }
    const bool right = (answer[0] != 0) == expected.has_value() && (!expected || answer[1] == *expected);
    if (right && answer[2] <= most_asked) result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    std::string text =
        fmt::format("origin     {}\ndirection  {}\nleaves     {}, from node {} on; node i has the children "
                    "2 i + 1 and 2 i + 2\n",
                    words(given.ray.origin), words(given.ray.direction), given.leaves(), given.leaves() - 1);
    for (int node = 0; node < given.nodes(); ++node) {
        const auto entry = entry_of(given, node);
        if (!entry) continue;
        text +=
            fmt::format("{}{} is entered at t = {:.6g}", node == 0 ? "The box of node " : ", of node ", node, *entry);
        if (!given.is_leaf(node)) continue;
        const auto hit = hit_of(given, node);
        text += hit ? fmt::format(" (a hit at {:.6g})", *hit) : " (no hit)";
    }
    return text + (entry_of(given, 0) ? "." : "The ray misses the root's box.");
}

}  // namespace

Exercise nearest_in_tree_exercise() {
    return exercise_on(nearest_in_tree_slot, answer,
                       {.chart = "hierarchy",
                        .inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "eight balls in a tree, the redder the more your function asks",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
