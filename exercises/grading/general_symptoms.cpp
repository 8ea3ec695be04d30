#include "general_symptoms.h"

#include "changed_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raylab::grading {

namespace {

using Kind = Part::Kind;

struct Placed {
    Part part;
    std::size_t first;
    std::span<const double> of(std::span<const double> answer) const { return answer.subspan(first, part.count); }
};

std::vector<Placed> placed_parts(const Exercise& exercise) {
    std::vector<Placed> all;
    std::size_t first = 0;
    for (const auto& part : exercise.parts) {
        all.push_back({part, first});
        first += part.count;
    }
    return all;
}

bool is_finite(std::span<const double> answer) {
    return std::ranges::all_of(answer, [](double value) { return std::isfinite(value); });
}

// Whether every part agrees with the right one, but for at least one that is as `changed` says: changed(part, right,
// given).
template <class Changed>
auto all_but(const std::vector<Placed>& parts, const Changed& changed) {
    return [parts, changed](const WrongAnswer& wrong) {
        if (!is_finite(wrong.given)) return false;
        bool seen = false;
        for (const auto& part : parts) {
            const auto right = part.of(wrong.right), given = part.of(wrong.given);
            if (agree(right, given)) continue;
            if (!changed(part.part, right, given)) return false;
            seen = true;
        }
        return seen;
    };
}

struct Factor {
    double value;
    const char* words;
};
constexpr double pi = std::numbers::pi;
constexpr std::array factors{Factor{2, "twice"},
                             Factor{0.5, "half of"},
                             Factor{4, "four times"},
                             Factor{0.25, "a quarter of"},
                             Factor{3, "three times"},
                             Factor{1.0 / 3, "a third of"},
                             Factor{pi, "pi times"},
                             Factor{1 / pi, "1 / pi times"},
                             Factor{2 * pi, "2 pi times"},
                             Factor{0.5 / pi, "1 / (2 pi) times"},
                             Factor{4 * pi, "4 pi times"},
                             Factor{0.25 / pi, "1 / (4 pi) times"},
                             Factor{180 / pi, "180 / pi times"},
                             Factor{pi / 180, "pi / 180 times"}};

bool has_size(const Part& part) { return part.kind == Kind::number || part.kind == Kind::vector; }

bool is_times(std::span<const double> right, double factor, std::span<const double> given) {
    std::vector<double> scaled(right.begin(), right.end());
    for (double& value : scaled) value *= factor;
    return agree(scaled, given);
}

void add_factors(std::vector<Symptom>& all, const std::vector<Placed>& parts) {
    for (const auto& [value, words] : factors)
        all.push_back({"factor", fmt::format("what you give is {} what is right", words),
                       all_but(parts, [value](const Part& part, auto right, auto given) {
                           return has_size(part) && is_times(right, value, given);
                       })});
    all.push_back({"turned_sign", "what you give is right but for its sign",
                   all_but(parts, [](const Part& part, auto right, auto given) {
                       return has_size(part) && is_times(right, -1, given);
                   })});
    const auto number = [&](const std::string& hint, const std::string& words, double (*changed)(double)) {
        all.push_back({hint, words, all_but(parts, [changed](const Part& part, auto right, auto given) {
                           return part.kind == Kind::number && agree(changed(right[0]), given[0]);
                       })});
    };
    number("squared", "what you give is the square of what is right", [](double x) { return x * x; });
    number("root", "what you give is the square root of what is right", [](double x) { return std::sqrt(x); });
    number("reciprocal", "what you give is 1 over what is right", [](double x) { return 1 / x; });
    number("complement", "what you give is 1 minus what is right", [](double x) { return 1 - x; });
}

void add_vectors(std::vector<Symptom>& all, const std::vector<Placed>& parts) {
    all.push_back({"not_unit_length", "the direction is right and its length is not",
                   all_but(parts, [](const Part& part, auto right, auto given) {
                       const double length = part.kind == Kind::vector ? std::hypot(given[0], given[1], given[2]) : 0;
                       return length > 0 && is_times(right, length / std::hypot(right[0], right[1], right[2]), given);
                   })});
    all.push_back({"axes", "the coordinates are right but have changed places",
                   all_but(parts, [](const Part& part, auto right, auto given) {
                       if (part.kind != Kind::vector) return false;
                       std::array<double, 3> a{right[0], right[1], right[2]}, b{given[0], given[1], given[2]};
                       std::ranges::sort(a), std::ranges::sort(b);
                       return agree(a, b);
                   })});
    all.push_back({"axis_sign", "one coordinate or two have the wrong sign",
                   all_but(parts, [](const Part& part, auto right, auto given) {
                       if (part.kind != Kind::vector) return false;
                       std::array<double, 3> a{}, b{};
                       for (std::size_t i = 0; i < 3; ++i) a[i] = std::abs(right[i]), b[i] = std::abs(given[i]);
                       return agree(a, b);
                   })});
    for (const int by : {1, -1})
        all.push_back({"off_by_one", fmt::format("a number is one too {}", by > 0 ? "large" : "small"),
                       all_but(parts, [by](const Part& part, auto right, auto given) {
                           return part.kind == Kind::indices &&
                                  std::ranges::equal(right, given,
                                                     [by](double a, double b) { return b == a || b == a + by; });
                       })});
}

// By which share of its largest number a part is wrong.
double relative_error(std::span<const double> right, std::span<const double> given) {
    double size = 0, off = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        size = std::max(size, std::abs(right[i]));
        off = std::max(off, std::abs(given[i] - right[i]));
    }
    return off / size;
}

// Floats have seven digits, and lose some where large numbers cancel.
void add_few_digits(std::vector<Symptom>& all, const std::vector<Placed>& parts) {
    const auto errs_by = [parts](double least, double most) {
        return [parts, least, most](const WrongAnswer& wrong) {
            double largest = 0;
            for (const auto& part : parts) {
                const auto right = part.of(wrong.right), given = part.of(wrong.given);
                if (std::ranges::equal(right, given)) continue;
                if (!has_size(part.part) || !is_finite(given)) return false;
                largest = std::max(largest, relative_error(right, given));
            }
            return largest >= least && largest <= most;
        };
    };
    all.push_back({"few_digits",
                   "what you give is right to five digits or more, and to no more than ten",
                   errs_by(1e-10, 5e-6),
                   {},
                   errs_by(1e-10, 1e-3)});
}

void add_flags(std::vector<Symptom>& all, const Placed& flag) {
    const auto at = flag.first;
    const auto says = [at](const WrongAnswer& wrong, double right, double given) {
        return wrong.right[at] == right && wrong.given[at] == given;
    };
    all.push_back({"missing", "there should be one, and you give none: " + flag.part.name,
                   [says](const WrongAnswer& wrong) { return says(wrong, 1, 0); }});
    all.push_back({"nothing_there", "there should be none, and you give one: " + flag.part.name,
                   [says](const WrongAnswer& wrong) { return says(wrong, 0, 1); }});
}

}  // namespace

std::vector<Symptom> general_symptoms(const Exercise& exercise) {
    std::vector<Symptom> all;
    all.push_back(
        {"not_a_number", "you give no number (0 / 0, or the root of what is negative)", [](const WrongAnswer& wrong) {
             return std::ranges::any_of(wrong.given, [](double value) { return std::isnan(value); });
         }});
    all.push_back({"infinite", "you give infinity (a division by 0)", [](const WrongAnswer& wrong) {
                       return std::ranges::any_of(wrong.given, [](double value) { return std::isinf(value); });
                   }});
    const auto parts = placed_parts(exercise);
    add_factors(all, parts);
    add_vectors(all, parts);
    std::ranges::move(changed_argument_symptoms(exercise), std::back_inserter(all));
    add_few_digits(all, parts);
    for (const auto& part : parts)
        if (part.part.kind == Kind::flag) add_flags(all, part);
    return all;
}

std::optional<Found> find_constant_answer(const Exercise& exercise, std::span<const double> answers,
                                          const Outcomes& outcomes) {
    if (outcomes.wrong.size() < 2) return std::nullopt;
    const auto answer = [&](std::size_t i) { return answers.subspan(i * exercise.outputs, exercise.outputs); };
    const auto first = answer(outcomes.wrong.front());
    const auto is_the_same = [&](std::size_t i) { return std::ranges::equal(answer(i), first); };
    if (!std::ranges::all_of(outcomes.wrong, is_the_same) || !std::ranges::all_of(outcomes.right, is_the_same))
        return std::nullopt;
    return Found{"always_the_same",
                 fmt::format("All {} answers are the same.", outcomes.wrong.size() + outcomes.right.size()),
                 outcomes.wrong.front()};
}

std::optional<Found> find_first_is_no_number(const Exercise& exercise, const std::vector<Case>& cases,
                                             std::span<const double> answers, const Outcomes& outcomes) {
    const auto is_no_number = [&](std::size_t i) {
        const auto answer = answers.subspan(i * exercise.outputs, exercise.outputs);
        return std::ranges::any_of(answer, [](double value) { return std::isnan(value); }) &&
               exercise.judge(cases[i], answer).outcome == Judgement::Outcome::nonfinite;
    };
    if (outcomes.wrong.empty() || !is_no_number(outcomes.wrong.front())) return std::nullopt;
    return Found{
        "not_a_number",
        fmt::format("{} of {} wrong answers are no numbers; case {} is the first.",
                    std::ranges::count_if(outcomes.wrong, is_no_number), outcomes.wrong.size(), outcomes.wrong.front()),
        outcomes.wrong.front()};
}

std::optional<Found> find_single_group(const std::vector<Case>& cases, const Outcomes& outcomes) {
    if (outcomes.wrong.empty() || outcomes.right.empty()) return std::nullopt;
    const auto& group = cases[outcomes.wrong.front()].group;
    const auto is_in = [&](std::size_t i) { return cases[i].group == group; };
    if (!std::ranges::all_of(outcomes.wrong, is_in) || std::ranges::all_of(outcomes.right, is_in)) return std::nullopt;
    const auto right = static_cast<std::size_t>(std::ranges::count_if(outcomes.right, is_in));
    return Found{
        "one_group",
        fmt::format("All {} other graded cases are right; of \"{}\" {} of {} are wrong.", outcomes.right.size() - right,
                    group, outcomes.wrong.size(), outcomes.wrong.size() + right),
        outcomes.wrong.front()};
}

}  // namespace raylab::grading
