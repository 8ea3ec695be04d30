#include "08c_listed_cells/slot.h"
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

using namespace listing;

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&),
                         Case::Kind kind = Case::Kind::graded) {
        for (int i = 0; i < count; ++i) all.push_back({group, kind, as_input(next(dice))});
    };
    add(30, "seen through one face as a whole", within_the_face);
    add(20, "out beyond an edge of the face", over_the_edge);
    add(25, "out beyond a corner of the face", past_a_corner);
    add(40, "from the light's front to behind it", behind_in_part);
    add(15, "a corner level with the light", level_with_the_light);
    add(15, "the whole face, and no corner to be seen", fills_the_face);
    add(20, "of more than six corners when it is cut", with_many_corners);
    add(30, "nothing to be seen", elsewhere);
    add(15, "small and large", any_length);
    add(15, "one cell", one_cell);
    add(30, "up to the border of a cell, in whole numbers", at_a_border);
    add(20, "up to the edge of the face, in whole numbers", at_the_edge);
    add(20, "within rounding of a border", hardly_at_a_border, Case::Kind::adversarial);
    return all;
}

std::string in_words(const std::optional<CellRectangle>& cells) {
    if (!cells) return "no cell";
    return fmt::format("columns {} to {}, rows {} to {}", cells->first_column, cells->last_column, cells->first_row,
                       cells->last_row);
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto given = arguments(question.input);
    const auto expected = truth(given);
    Judgement result{.expected = in_words(expected), .got = in_words(read_cells(answer))};
    if (!std::ranges::all_of(answer, [](double x) { return std::isfinite(x); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (read_cells(answer) == expected)
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    constexpr std::array names{"+x", "-x", "+y", "-y", "+z", "-z"};
    const auto given = arguments(question.input);
    std::string text = fmt::format("face        {} ({})\nresolution  {}\n", given.face,
                                   names[static_cast<std::size_t>(given.face)], given.resolution);
    for (const Vec3d& corner : given.corners) {
        const auto [u, v, w] = seen_by(corner, given.face);
        text += fmt::format("corner      {}: u = {:.6g}, v = {:.6g}, w = {:.6g}\n", words(corner),
                            static_cast<double>(u), static_cast<double>(v), static_cast<double>(w));
    }
    const Window seen = window(given);
    if (seen.is_empty()) return text + "Nothing of it is seen through this face.";
    return text + fmt::format("What is seen reaches from {:.6g} to {:.6g} along the columns' axis and from {:.6g} to "
                              "{:.6g} along the rows'; the face is -1 to 1.",
                              static_cast<double>(seen.left), static_cast<double>(seen.right),
                              static_cast<double>(seen.low), static_cast<double>(seen.high));
}

}  // namespace

Exercise listed_cells_exercise() {
    return exercise_on(listed_cells_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = room_picture()});
}

}  // namespace raylab::grading
