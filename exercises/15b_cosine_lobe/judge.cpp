#include "15b_cosine_lobe/slot.h"
#include "arguments.h"
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
#include <numbers>

namespace raylab::grading {

namespace {

using namespace cosine_lobe;

constexpr double tolerance = 1e-9;

Case make_lobe_case(const std::string& group, Case::Kind kind, double which) { return {group, kind, {which}}; }

std::vector<Case> lobe_cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    for (std::size_t i = 0; i < 6; ++i)
        all.push_back(make_lobe_case("directions all over the hemisphere", Case::Kind::graded,
                                     spread_seed(dice, cells_in_turn(i))));
    all.push_back(make_lobe_case("numbers at the ends", Case::Kind::graded, numbers::at_ends));
    all.push_back(make_lobe_case("numbers rounded up to 1", Case::Kind::adversarial, numbers::rounded_to_one));
    return all;
}

// What is wrong with one direction, whatever the others are: what was expected, and what came; or nothing.
struct Complaint {
    Judgement::Outcome outcome;
    std::string expected, got;
};

std::optional<Complaint> complaint(const SampledDirection& sampled) {
    const Vec3d& d = sampled.direction;
    const double length = glm::length(d);
    if (!is_finite(sampled))
        return Complaint{Judgement::Outcome::nonfinite, "a direction with its density",
                         words(d) + " with the density " + words(sampled.pdf)};
    if (std::abs(length - 1) > tolerance)
        return Complaint{Judgement::Outcome::wrong, "a direction of length 1",
                         words(d) + " of length " + words(length)};
    if (d.z < -tolerance)
        return Complaint{Judgement::Outcome::wrong, "a direction above the surface, z >= 0", words(d)};
    if (std::abs(sampled.pdf - right_density(sampled)) > tolerance)
        return Complaint{Judgement::Outcome::wrong,
                         fmt::format("the density {} of {}", words(right_density(sampled)), words(d)),
                         words(sampled.pdf)};
    return std::nullopt;
}

Judgement judge_lobe(const Case& question, std::span<const double> answer) {
    const double which = question.input[0];
    for (std::size_t i = 0; i < pairs; ++i)
        if (auto found = complaint(sampled(answer, i))) {
            const auto [u, v] = number_pairs(which)[i];
            return {found->outcome, fmt::format("for u = {}, v = {} {}", u, v, found->expected), found->got};
        }
    const PointWords words{"directions in proportion to their cosine, each with its density",
                           "directions at all angles from z, and around it", "angles from z", "angles around z"};
    if (!are_spread(which)) return {Judgement::Outcome::right, words.right, words.right};
    const auto shares = lobe_shares(answer);
    const auto uneven = uneven_part(shares, cells_of(which));
    if (!uneven) return judged_by_steps(shares, words);
    const auto degrees = [](double inside) { return 180 / std::numbers::pi * std::asin(std::sqrt(inside)); };
    return {Judgement::Outcome::wrong,
            fmt::format("{:.4g} % of the directions {:.3g} to {:.3g} degrees from z, at {:g} to {:g} degrees around it",
                        100 * uneven->expected, degrees(uneven->from_inside), degrees(uneven->to_inside),
                        360 * uneven->from_turn, 360 * uneven->to_turn),
            fmt::format("{:.4g} %", 100 * uneven->found)};
}

// Of all directions: how long, how many below the surface; the density beside the right one; whether the angle around z
// is in degrees or in whole steps, which spreads nearly as it should; how they are spread.
std::vector<double> lobe_fingerprint(const Case& question, std::span<const double> answer) {
    double lost = 0, lost_ways = 0, longest = 0, below = 0, larger = 0, smaller = 0, weight = 0, ratio = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        const SampledDirection one = sampled(answer, i);
        if (!is_finite(one)) {
            lost = 1;
            lost_ways = std::isfinite(one.direction.x) ? lost_ways : 1;
            continue;
        }
        const double right = std::abs(one.direction.z) / std::numbers::pi, share = 1 / static_cast<double>(pairs);
        longest = std::max(longest, glm::length(one.direction));
        below += one.direction.z < -tolerance ? share : 0;
        larger += one.pdf > right + tolerance ? share : 0;
        smaller += one.pdf < right - tolerance ? share : 0;
        weight += std::clamp(one.pdf, -10.0, 10.0) * share;
        ratio += right > 0 ? std::clamp(one.pdf / right, -10.0, 10.0) * share : 0;
    }
    std::vector<double> symptoms{lost, longest, below, larger, smaller, weight, ratio};
    if (!are_spread(question.input[0]))
        return {lost, lost_ways, longest > 1 + tolerance ? 1.0 : 0.0,
                are_lost_in_the_middle({answer, question.input[0]}) ? 1.0 : 0.0};
    const auto shares = lobe_shares(answer);
    symptoms.push_back(turn_by_degrees(shares, number_pairs(question.input[0])));
    symptoms.push_back(have_whole_steps(shares));
    std::ranges::copy(spread_symptoms(shares), std::back_inserter(symptoms));
    return symptoms;
}

std::string lobe_story(const Case& question) { return "numbers    " + numbers_in_words(question.input[0]); }

PlaneDrawing lobe_sketch(const Case&, std::span<const double> answer) {
    const SampledDirection first = sampled(answer, 0);
    return spread_sketch(lobe_shares(answer), with_density("some of your directions, from above: x to the right",
                                                           right_density(first), first.pdf));
}

}  // namespace

Exercise cosine_lobe_exercise() {
    return exercise_on(cosine_direction_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = lobe_cases,
                        .judge = judge_lobe,
                        .symptoms = symptoms(),
                        .fingerprint = lobe_fingerprint,
                        .fingerprint_noise = spread_noise,
                        .story = lobe_story,
                        .sketch = lobe_sketch,
                        .picture = lobe_picture()});
}

}  // namespace raylab::grading
