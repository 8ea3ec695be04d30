#include "15_lens/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "spread.h"
#include "spread_judgement.h"
#include "spread_sketch.h"
#include "symptoms.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace lens;

constexpr double rounding = 1e-9;  // of a point's distance from the centre, relative to the radius

Case make_lens_case(const std::string& group, Case::Kind kind, double radius, double which) {
    return {group, kind, {radius, which}};
}

std::vector<Case> lens_cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    for (std::size_t i = 0; i < ways_to_cut; ++i) {
        const auto add = [&](const std::string& group, double radius) {
            all.push_back(make_lens_case(group, Case::Kind::graded, radius, spread_seed(dice, cells_in_turn(i))));
        };
        add("a lens of radius 1", 1);
        add("lenses of millimetres", dice.in(0.0005, 0.05));
        add("lenses of metres", dice.in(1.5, 30));
    }
    for (const double radius : {1.0, 0.02})
        all.push_back(make_lens_case("numbers at the ends", Case::Kind::graded, radius, numbers::at_ends));
    all.push_back(make_lens_case("numbers rounded up to 1", Case::Kind::adversarial, 1, numbers::rounded_to_one));
    return all;
}

std::string lens_point_in_words(std::span<const double> answer, std::size_t i) {
    return fmt::format("({:.6g}, {:.6g}), {:.6g} from the centre", answer[2 * i], answer[2 * i + 1],
                       std::hypot(answer[2 * i], answer[2 * i + 1]));
}

Judgement one_point(Judgement::Outcome outcome, const LensCase& given, std::span<const double> answer, std::size_t i) {
    const auto [u, v] = number_pairs(given.which)[i];
    return {outcome, fmt::format("for u = {}, v = {} a point at most {:.6g} from the centre", u, v, given.radius),
            lens_point_in_words(answer, i)};
}

Judgement judge_lens(const Case& question, std::span<const double> answer) {
    const LensCase given = lens_case(question);
    const auto points = lens_shares(answer, given.radius);
    const auto lost = std::ranges::find_if_not(points, [](const auto& point) { return std::isfinite(point.inside); });
    if (lost != points.end())
        return one_point(Judgement::Outcome::nonfinite, given, answer, static_cast<std::size_t>(lost - points.begin()));
    const auto farthest = std::ranges::max_element(points, {}, &DrawnShare::inside);
    if (std::sqrt(farthest->inside) > 1 + rounding)
        return one_point(Judgement::Outcome::wrong, given, answer, static_cast<std::size_t>(farthest - points.begin()));
    const PointWords words{"points all over the lens, evenly", "points in all directions, at all distances",
                           "distances", "directions from the centre"};
    if (!are_spread(given.which)) return {Judgement::Outcome::right, words.right, words.right};
    const auto uneven = uneven_part(points, cells_of(given.which));
    if (!uneven) return judged_by_steps(points, words);
    const std::string where =
        fmt::format("of the points {:.4g} to {:.4g} from the centre, at {:g} to {:g} degrees",
                    given.radius * std::sqrt(uneven->from_inside), given.radius * std::sqrt(uneven->to_inside),
                    360 * uneven->from_turn, 360 * uneven->to_turn);
    return {Judgement::Outcome::wrong, fmt::format("{:.4g} % {}", 100 * uneven->expected, where),
            fmt::format("{:.4g} %", 100 * uneven->found)};
}

// Whether the points leave the lens, and by how much, how they are spread, whether their angle is in degrees (by all
// others of these numbers that mistake is too near to what is right), and whether they fill a curve only, which winds
// so often that it is spread as an area, or lines with nothing between them.
std::vector<double> lens_fingerprint(const Case& question, std::span<const double> answer) {
    const LensCase given = lens_case(question);
    const auto points = lens_shares(answer, given.radius);
    double largest = 0, lost = 0;
    for (const auto& point : points) {
        if (std::isfinite(point.inside)) largest = std::max(largest, std::sqrt(point.inside));
        lost += !std::isfinite(point.inside);
    }
    std::vector<double> symptoms{largest, std::min(1.0, lost)};
    if (!are_spread(given.which)) return symptoms;  // how a grid is spread tells of the grid
    symptoms.push_back(turn_by_degrees(points, number_pairs(given.which)));
    symptoms.push_back(lie_on_a_curve(points));
    symptoms.push_back(have_whole_steps(points));
    std::ranges::copy(spread_symptoms(points), std::back_inserter(symptoms));
    return symptoms;
}

std::string lens_story(const Case& question) {
    const auto [radius, which] = lens_case(question);
    return fmt::format("radius     {}\nnumbers    {}", words(radius), numbers_in_words(which));
}

PlaneDrawing lens_sketch(const Case& question, std::span<const double> answer) {
    return spread_sketch(lens_shares(answer, lens_case(question).radius),
                         {"the lens from its axis, and some of your points", "right: evenly", "yours"});
}

}  // namespace

Exercise lens_exercise() {
    return exercise_on(lens_point_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = lens_cases,
                        .judge = judge_lens,
                        .symptoms = symptoms(),
                        .fingerprint = lens_fingerprint,
                        .fingerprint_noise = spread_noise,
                        .story = lens_story,
                        .sketch = lens_sketch,
                        .picture = lens_picture()});
}

}  // namespace raylab::grading
