#include "15c_light_point/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "seen_light.h"
#include "spread.h"
#include "spread_judgement.h"
#include "spread_sketch.h"
#include "symptoms.h"
#include "whole_numbers.h"
#include "words.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::grading {

namespace {

using namespace light;

// A light of a hundredth of its distance: 1 - cos as it stands keeps eleven digits, and the root of a quadratic
// equation eight of the depth at the light's edge, where depth is along the light.
constexpr double density_tolerance = 1e-9;  // relative
constexpr double reach_tolerance = 1e-7;    // of the radius
constexpr double side_tolerance = 1e-4;     // of a cosine, at the edge

// A light of this radius as a share of its distance, in any direction from any point.
Arguments any_light(Dice& dice, double least, double most, Cells cut, double scale = 1) {
    const Vec3d from = dice.point(-3, 3) * scale;
    const double distance = dice.in(1, 5) * scale;
    const Vec3d center = from + distance * dice.direction();
    return {center, dice.in(least, most) * distance, from, spread_seed(dice, cut)};
}

// A light of which the ray along its edge passes, by rounding, as two usual formulas have it: its distance from the
// centre, squared, is a little more than the radius squared.
Arguments light_with_rough_edge(Dice& dice, double least, double most) {
    for (;;) {
        Arguments given = any_light(dice, least, most, Cells::squares);
        given.which = numbers::at_ends;
        const Vec3d way = given.center - given.from;
        const double radius = given.radius, distance = glm::length(way), sine = radius / distance;
        const double cosine = 1 - (1 - 0x1p-53) * (1 - std::sqrt(1 - sine * sine));
        const double aside = distance * std::sqrt(1 - cosine * cosine), along = distance * cosine;
        if (radius * radius < aside * aside && along * along < dot(way, way) - radius * radius) return given;
    }
}

std::vector<Case> light_cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](const std::string& group, const Arguments& given, Case::Kind kind = Case::Kind::graded) {
        all.push_back({group, kind, as_input(given)});
    };
    using enum Cells;
    add("straight above", {{0, 0, dice.in(3, 5)}, dice.in(0.8, 1.2), {0, 0, 0}, spread_seed(dice, squares)});
    for (const int axis : {0, 1, 2})
        for (const double ahead : {1, -1}) {
            Vec3d center{0, 0, 0};
            center[axis] = ahead * dice.in(3, 5);
            add("along an axis", {center, dice.in(0.8, 1.2), {0, 0, 0}, spread_seed(dice, squares)});
            const Vec3d from = whole_point(dice, -3, 3);
            add("along an axis", {from + along(axis, ahead * whole(dice, 3, 5)), 1, from, spread_seed(dice, squares)});
        }
    add("anywhere", any_light(dice, 0.2, 0.6, squares));
    add("anywhere", any_light(dice, 0.2, 0.6, strips_of_u));
    add("anywhere", any_light(dice, 0.2, 0.6, strips_of_v));
    add("close by", any_light(dice, 0.9, 0.98, squares));
    add("close by", any_light(dice, 0.9, 0.98, strips_of_u));
    add("small", any_light(dice, 0.01, 0.03, squares));
    add("small", any_light(dice, 0.01, 0.03, strips_of_v));
    add("of micrometres, and of kilometres", any_light(dice, 0.2, 0.6, squares, 1e-6));
    add("of micrometres, and of kilometres", any_light(dice, 0.2, 0.6, squares, 1e3));
    for (const bool close : {false, true}) {
        Arguments given = close ? any_light(dice, 0.9, 0.98, squares) : any_light(dice, 0.2, 0.6, squares);
        given.which = numbers::at_ends;
        add("numbers at the ends", given);
    }
    for (int i = 0; i < 4; ++i) add("numbers at the ends", light_with_rough_edge(dice, 0.2, 0.9));
    for (int i = 0; i < 2; ++i)
        add("as small as a star", any_light(dice, 1e-7, 1e-5, squares), Case::Kind::adversarial);
    Arguments with_one = any_light(dice, 0.2, 0.6, squares);
    with_one.which = numbers::rounded_to_one;
    add("numbers rounded up to 1", with_one, Case::Kind::adversarial);
    return all;
}

bool is_finite(const LightPoint& point) {
    return std::isfinite(dot(point.point, point.point)) && std::isfinite(point.pdf);
}

// What is wrong with one point, whatever the others are: what was expected, and what came; or nothing.
struct PointComplaint {
    Judgement::Outcome outcome;
    std::string expected, got;
};

std::optional<PointComplaint> point_complaint(const SeenLight& seen, const LightPoint& one) {
    using enum Judgement::Outcome;
    if (!is_finite(one))
        return PointComplaint{nonfinite, "a point with its density",
                              words(one.point) + " with the density " + words(one.pdf)};
    if (std::abs(seen.reach(one.point) - 1) > reach_tolerance)
        return PointComplaint{
            wrong, "a point of the light's surface",
            fmt::format("{}, {} radii from the centre", words(one.point), words(seen.reach(one.point)))};
    if (seen.side(one.point) < seen.relative_radius() - side_tolerance)
        return PointComplaint{wrong, "a point that is seen from the lit one",
                              words(one.point) + ", which is on the far side"};
    if (std::abs(one.pdf / seen.density() - 1) > density_tolerance)
        return PointComplaint{wrong, fmt::format("the density {}", words(seen.density())),
                              fmt::format("{}, which is {:.6g} of it", words(one.pdf), one.pdf / seen.density())};
    return std::nullopt;
}

Judgement judge_light(const Case& question, std::span<const double> answer) {
    const Arguments given = arguments(question.input);
    const SeenLight seen(given);
    for (std::size_t i = 0; i < pairs; ++i)
        if (auto found = point_complaint(seen, chosen(answer, i))) {
            const auto [u, v] = number_pairs(given.which)[i];
            return {found->outcome, fmt::format("for u = {}, v = {} {}", u, v, found->expected), found->got};
        }
    const PointWords words{"points all over the light that is seen, evenly, each with its density",
                           "points at all angles from the light's middle, and around it", "angles from the middle",
                           "angles around it"};
    if (!are_spread(given.which)) return {Judgement::Outcome::right, words.right, words.right};
    const auto shares = seen.shares(answer);
    const auto uneven = uneven_part(shares, cells_of(given.which));
    if (!uneven) return judged_by_steps(shares, words);
    return {
        Judgement::Outcome::wrong,
        fmt::format("{:.4g} % of the directions in what is {:g} to {:g} of the light's solid angle from its middle, "
                    "at {:g} to {:g} degrees around it",
                    100 * uneven->expected, uneven->from_inside, uneven->to_inside, 360 * uneven->from_turn,
                    360 * uneven->to_turn),
        fmt::format("{:.4g} %", 100 * uneven->found)};
}

// Of all points: on the light or where, how many on the far side; the density beside the right one; whether the angle
// around the middle is in degrees or in whole steps, which spreads nearly as it should; how the directions are spread.
std::vector<double> light_fingerprint(const Case& question, std::span<const double> answer) {
    const Arguments given = arguments(question.input);
    const SeenLight seen(given);
    const double share = 1 / static_cast<double>(pairs);
    double lost = 0, near = 0, far = 0, reach = 0, behind = 0, larger = 0, smaller = 0, logarithm = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        const LightPoint one = chosen(answer, i);
        if (!is_finite(one)) {
            lost = 1;
            continue;
        }
        const double of_radius = std::min(seen.reach(one.point), 100.0), density = one.pdf / seen.density();
        near += of_radius < 1 - reach_tolerance ? share : 0;
        far += of_radius > 1 + reach_tolerance ? share : 0;
        reach += of_radius * share;
        behind += seen.side(one.point) < seen.relative_radius() - side_tolerance ? share : 0;
        larger += density > 1 + density_tolerance ? share : 0;
        smaller += density < 1 - density_tolerance ? share : 0;
        logarithm += std::clamp(std::log(std::abs(density)), -100.0, 100.0) * share;
    }
    if (!are_spread(given.which)) return {lost, near > 0 ? 1.0 : 0.0, far > 0 ? 1.0 : 0.0};
    std::vector<double> symptoms{lost, near, far, reach, behind, larger, smaller, logarithm};
    const auto shares = seen.shares(answer);
    symptoms.push_back(turn_by_degrees(shares, number_pairs(given.which)));
    symptoms.push_back(have_whole_steps(shares));
    std::ranges::copy(spread_symptoms(shares), std::back_inserter(symptoms));
    return symptoms;
}

std::string light_story(const Case& question) {
    const Arguments given = arguments(question.input);
    const SeenLight seen(given);
    return fmt::format(
        "light      radius {} around {}\nlit point  {}\nnumbers    {}\nThe light's radius is {:.4g} of its "
        "distance: it is seen in {:.4g} steradians, up to {:.4g} degrees from its middle.",
        words(given.radius), words(given.center), words(given.from), numbers_in_words(given.which),
        seen.relative_radius(), 1 / seen.density(), 180 / std::numbers::pi * std::asin(seen.relative_radius()));
}

PlaneDrawing light_sketch(const Case& question, std::span<const double> answer) {
    const SeenLight seen(arguments(question.input));
    return spread_sketch(seen.shares(answer), with_density("the light as it is seen, and some of your points on it",
                                                           seen.density(), chosen(answer, 0).pdf));
}

}  // namespace

Exercise light_point_exercise() {
    return exercise_on(light_point_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = light_cases,
                        .judge = judge_light,
                        .symptoms = symptoms(),
                        .fingerprint = light_fingerprint,
                        .fingerprint_noise = spread_noise,
                        .story = light_story,
                        .sketch = light_sketch,
                        .picture = light_picture()});
}

}  // namespace raylab::grading
