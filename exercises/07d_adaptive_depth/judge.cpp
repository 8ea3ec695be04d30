#include "07d_adaptive_depth/slot.h"
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

using namespace branches;

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const std::string& group, Arguments (*next)(Dice&),
                         Case::Kind kind = Case::Kind::graded) {
        for (int i = 0; i < count; ++i) all.push_back({group, kind, as_input(next(dice))});
    };
    add(40, "many levels are left", many_levels);
    add(50, "few levels are left", few_levels);
    add(40, "all levels together bring enough, and none of them alone", all_levels_count);
    add(30, "the last level but one", last_but_one);
    add(20, "no level is left", no_level_left);
    add(40, "one branch of two is worth it", one_of_two);
    add(20, "not even both branches together are worth it", not_even_both);
    add(20, "neither branch is worth it, and both together would be", both_together);
    add(20, "not even the ray that arrives would be worth it", not_even_the_ray);
    add(30, "rho is 1", all_is_mirrored);
    add(20, "rho is nearly 1", nearly_all);
    add(30, "rho is a little less than 1, and many levels are left", a_little_below_one);
    add(30, "a dim scene", dim);
    add(30, "exactly the least, in powers of two", exactly_the_least);
    add(20, "a share is 0, and nothing may be lost", opaque_or_black);
    add(20, "a faint ray in a bright scene", faint);
    add(20, "the least up to rounding", up_to_rounding, Case::Kind::adversarial);
    return all;
}

std::string in_words(double reflected, double transmitted) {
    const auto one = [](double weight) { return weight == 0 ? "not followed" : "weight " + words(weight); };
    return "reflected: " + one(reflected) + "; transmitted: " + one(transmitted);
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const auto [reflected, transmitted] = truth(of(question));
    Judgement result{.expected = in_words(reflected, transmitted), .got = in_words(answer[0], answer[1])};
    const auto is = [](double given, double weight) { return std::abs(given - weight) <= 1e-9 * weight; };
    if (!std::isfinite(answer[0]) || !std::isfinite(answer[1]))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (is(answer[0], reflected) && is(answer[1], transmitted))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto given = of(question);
    const double series_of = series(given.largest_share, given.levels);
    return fmt::format(
        "weight         {:.10g}\nshares         {:.10g} reflected, {:.10g} transmitted\nlevels         {}\n"
        "brightest      {:.10g}\nlargest share  {:.10g}\nleast          {:.10g}\n"
        "A ray of weight w can bring {:.6g} w at most: the mirrored one {:.6g}, the refracted one {:.6g}.",
        given.weight, given.reflected, given.transmitted, given.levels, given.brightest, given.largest_share,
        given.least, given.brightest * series_of, most(given, given.reflected), most(given, given.transmitted));
}

}  // namespace

Exercise adaptive_depth_exercise() {
    return exercise_on(followed_branches_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::number, "the weight"},
                                      {Part::Kind::number, "the reflected share"},
                                      {Part::Kind::number, "the transmitted share"},
                                      {Part::Kind::indices, "levels", 1},
                                      {Part::Kind::number, "the brightest"},
                                      {Part::Kind::number, "the largest share"},
                                      {Part::Kind::number, "the least"}},
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "how deep rays are followed (downward) between panes that mirror and let "
                                             "through more and more (to the right)",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
