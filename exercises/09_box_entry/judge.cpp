#include "09_box_entry/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "questions.h"
#include "sketch.h"
#include "symptoms.h"
#include "truth.h"
#include "walk.h"
#include "words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace boxes;

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const std::string& group, const auto& next,
                         Case::Kind kind = Case::Kind::graded) {
        for (std::size_t added = 0; added < count;) {
            const Question question = next(dice);
            const bool decided = question.numbers == Question::Numbers::exact || keeps_margin(question.given);
            if (kind == Case::Kind::graded && !decided) continue;
            all.push_back({group, kind, as_input(question.given)});
            ++added;
        }
    };
    add(40, "through the box", through);
    add(40, "anywhere", anywhere);
    add(30, "the start is in the box", from_inside);
    add(30, "the box is behind", behind);
    add(30, "the range ends before the box", too_short);
    add(30, "the range begins in the box or beyond it", begins_late);
    add(30, "a range that begins before the start", begins_before_start);
    add(30, "the start is in the box, and the range begins outside", starts_elsewhere);
    add(20, "a range without ends", endless);
    add(20, "a range that ends on a face, in whole numbers", ends_at_face);
    add(30, "along an axis", along_axis);
    add(40, "along an axis, in the plane of a face", in_face);
    add(30, "a box without thickness", flat);
    add(20, "long and short directions", any_length);
    add(30, "through a corner", at_corner, Case::Kind::adversarial);
    add(30, "far away, along an axis, in the plane of a face", far_in_face, Case::Kind::adversarial);
    return all;
}

std::string in_words(bool hit, double t) { return hit ? "in the box from t = " + words(t) : "never in the box"; }

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto truth = first_inside(arguments(question.input));
    const auto expected = static_cast<double>(truth.value_or(0));
    // Of a ray that goes a kilometre while t grows by one, a billionth of t is a micrometre.
    const double nearest = 1 / glm::length(arguments(question.input).ray.direction);
    Judgement result{.expected = in_words(truth.has_value(), expected), .got = in_words(answer[0] != 0, answer[1])};
    if (!std::isfinite(answer[0]) || !std::isfinite(answer[1]))
        result.outcome = Judgement::Outcome::nonfinite;
    else if ((answer[0] != 0) == truth.has_value() &&
             (!truth || std::abs(answer[1] - expected) <= 1e-9 * std::max(nearest, std::abs(expected))))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto [ray, low, high] = arguments(question.input);
    std::string text = fmt::format("origin     {}\ndirection  {}\nrange      {} to {}\nbox        from "
                                   "{}\n           to   {}\n",
                                   words(ray.origin), words(ray.direction), words(ray.range.min), words(ray.range.max),
                                   words(low), words(high));
    for (int axis = 0; axis < 3; ++axis) {
        const char name = "xyz"[axis];
        if (ray.direction[axis] == 0) {
            const bool between = ray.origin[axis] >= low[axis] && ray.origin[axis] <= high[axis];
            text += fmt::format("{}: {} the planes, all along\n", name, between ? "between" : "not between");
        } else {
            const double a = (low[axis] - ray.origin[axis]) / ray.direction[axis],
                         b = (high[axis] - ray.origin[axis]) / ray.direction[axis];
            text += fmt::format("{}: between the planes from t = {} to {}\n", name, words(std::min(a, b)),
                                words(std::max(a, b)));
        }
    }
    return text;
}

// Towers seen vertically from above: the rays of the pixels go down along their walls.
constexpr int picture_size = 96, pixels_a_metre = 12;
constexpr std::array<std::array<double, 5>, 6> towers{
    {{1, 1, 3, 3, 3}, {3, 1, 4, 2, 1}, {5, 1, 7, 4, 2}, {1, 4, 2, 7, 1}, {2, 5, 4, 7, 2.5}, {5, 5, 6, 6, 1.5}}};

std::vector<Case> pixel_cases(int x, int y) {
    std::vector<Case> all;
    for (const auto& [x0, y0, x1, y1, height] : towers)
        all.push_back({"", Case::Kind::graded,
                       as_input({{{double(x) / pixels_a_metre, double(y) / pixels_a_metre, 4}, {0, 0, -1}, {0, 100}},
                                 {x0, y0, 0},
                                 {x1, y1, height}})});
    return all;
}

Pixel shade(int, int, std::span<const double> answers) {
    double nearest = 4.4;
    for (std::size_t i = 0; i + 1 < answers.size(); i += 2)
        if (answers[i] != 0 && answers[i + 1] < nearest) nearest = answers[i + 1];
    const auto grey = cast<float>(std::clamp(1 - nearest / 4.8, 0.0, 1.0));
    return {grey, grey, cast<float>(0.3 + 0.7 * grey)};
}

}  // namespace

Exercise box_entry_exercise() {
    return exercise_on(box_entry_slot, answer,
                       {.chart = "ray_box",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::vector, "the origin", 3},
                                      {Part::Kind::direction, "the direction", 3},
                                      {Part::Kind::number, "range.min"},
                                      {Part::Kind::number, "range.max"},
                                      {Part::Kind::vector, "low", 3},
                                      {Part::Kind::vector, "high", 3}},
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::flag, "an entry"}, {Part::Kind::number, "t"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "towers from straight above, each pixel's ray along whole and half metres",
                                    .width = picture_size,
                                    .height = picture_size,
                                    .cases = pixel_cases,
                                    .shade = shade},
                        .work = work_tasks()});
}

}  // namespace raylab::grading
