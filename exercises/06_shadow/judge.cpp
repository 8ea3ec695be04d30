#include "06_shadow/slot.h"
#include "arguments.h"
#include "cases.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "symptoms.h"
#include "truth.h"
#include "words.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace shadow;

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const auto& next) {
        for (std::size_t added = 0; added < count;) {
            auto question = next(dice);
            if (question.kind == Case::Kind::graded && !keeps_margin(arguments(question.input))) continue;
            all.push_back(std::move(question));
            ++added;
        }
    };
    add(30, free_way);
    add(30, below_surface);
    add(40, between);
    add(40, beyond_light);
    add(30, behind_point);
    add(30, light_behind);
    add(30, close_by);
    add(40, [](Dice& d) { return anything(d, "several spheres", 1); });
    add(20, under_large);
    add(20, close_in_small);
    add(20, very_close_in_small);
    add(30, far_from_origin);
    add(20, far_light);
    add(20, before_light);
    add(30, right_before_light);
    add(40, short_way_far_off);
    add(40, low_light);
    add(30, light_on_ball);
    add(30, grazing);
    return all;
}

std::string in_words(bool dark) { return dark ? "in shadow" : "lit"; }

Judgement judge(const Case& question, std::span<const double> answer) {
    const bool expected = is_dark(arguments(question.input));
    Judgement result{.expected = in_words(expected), .got = in_words(answer[0] != 0)};
    if (!std::isfinite(answer[0]))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (answer[0] == (expected ? 1 : 0))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = arguments(question.input);
    std::string words_ = fmt::format("point   {}\nnormal  {}\nlight   {}\n", words(given.point), words(given.normal),
                                     words(given.light));
    for (const auto& sphere : given.spheres) {
        if (sphere.radius == 0) continue;
        const auto clear = static_cast<double>(clearance(given, sphere));
        words_ += fmt::format("sphere  at {}, radius {:.4g}: {}\n", words(sphere.center), sphere.radius,
                              clear < 0 ? "in the way" : fmt::format("not in the way, {:.3g} from it", clear));
    }
    return words_ + fmt::format("The surface is {:.2g} {} the point (rounding); the light "
                                "is {} it.",
                                std::abs(given.above), given.above > 0 ? "above" : "below",
                                is_behind(given) ? "behind" : "before");
}

std::vector<Case> pixel_cases(int x, int y) {
    const Seen seen = seen_at(x, y);
    // As rounding would: above and below in stripes.
    const double above =
        2e-12 * std::sin(9 * seen.point.x + 23 * seen.point.z) * std::max(1.0, largest_coordinate(seen.point)) / 2;
    return {make("", Case::Kind::graded, {seen.point, seen.normal, light, above, balls})};
}

Pixel shade(int x, int y, std::span<const double> answer) {
    const Seen seen = seen_at(x, y);
    if (!seen.hit || !std::isfinite(answer[0])) return {0.02f, 0.03f, 0.06f};
    const Vec3d to_light = glm::normalize(light - seen.point);
    const double lit = 0.15 + (answer[0] != 0 ? 0 : 0.85 * std::max(0.0, dot(seen.normal, to_light)));
    return {cast<float>(seen.color.x * lit), cast<float>(seen.color.y * lit), cast<float>(seen.color.z * lit)};
}

}  // namespace

Exercise shadow_exercise() {
    return exercise_on(in_shadow_slot, answer,
                       {.chart = "shadow_ray",
                        .inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .parts = {{Part::Kind::flag, "a shadow"}},
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "balls about a light, with the shadows of the function",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
