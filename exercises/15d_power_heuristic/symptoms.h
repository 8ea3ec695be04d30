#pragma once

#include "arguments.h"
#include "symptom.h"

#include <algorithm>
#include <cmath>
#include <limits>

// What wrong answers to this exercise have in common.

namespace raylab::grading::heuristic {

inline double pdf_of(const Case& question) { return question.input[0]; }
inline double other_of(const Case& question) { return question.input[1]; }

inline bool is_infinite(const Case& question) { return std::isinf(pdf_of(question)) || std::isinf(other_of(question)); }

/// Whether the square of a density is more than a double can hold, or less, and the density itself is neither.
inline bool is_huge(const Case& question) {
    return !is_infinite(question) && std::max(pdf_of(question), other_of(question)) > 1e154;
}
inline bool is_tiny(const Case& question) { return std::max(pdf_of(question), other_of(question)) < 1e-162; }
inline bool is_extreme(const Case& question) { return is_huge(question) || is_tiny(question) || is_infinite(question); }

/// The weight as another function of the density and of the ratio other / pdf. Where squares leave the doubles, a
/// second mistake is likely, and says nothing against this one.
using Weight = long double (*)(long double pdf, long double ratio);

inline long double ratio_of(const Case& question) {
    if (std::isinf(pdf_of(question))) return 0;
    return static_cast<long double>(other_of(question)) / static_cast<long double>(pdf_of(question));
}

inline Symptom instead(const std::string& hint, const std::string& words, Weight other) {
    const auto value = [other](const Case& question) {
        return static_cast<double>(other(pdf_of(question), ratio_of(question)));
    };
    const auto shows = [value](const WrongAnswer& w) {
        return is_extreme(w.question) || agree(w.given[0], value(w.question));
    };
    // A weight that is right where this one is not contradicts it.
    const auto differs = [value](const Case& question) {
        const long double ratio = ratio_of(question);
        return !is_extreme(question) && std::abs(value(question) - static_cast<double>(1 / (1 + ratio * ratio))) > 1e-6;
    };
    return {hint, words, shows, differs, shows};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"infinity_over_infinity", "a density is infinite",
         [](const WrongAnswer& w) { return is_infinite(w.question); }});
    add({"small_ones_are_nothing", "both densities are small, and you give 0, a half or 1",
         [](const WrongAnswer& w) {
             return std::max(pdf_of(w.question), other_of(w.question)) < 1e-3 &&
                    (w.given[0] == 0 || w.given[0] == 0.5 || w.given[0] == 1);
         },
         is_tiny});
    add({"squares_leave_the_doubles", "the square of a density is more than a double can hold, or less",
         [](const WrongAnswer& w) { return is_extreme(w.question); }});
    add({"nothing_beside_zero", "the other strategy never chooses the direction, and you do not give 1",
         [](const WrongAnswer& w) { return other_of(w.question) == 0; },
         [](const Case& q) { return other_of(q) == 0; }});
    const auto weight = [&](const std::string& hint, const std::string& words, Weight other) {
        add(instead(hint, words, other));
    };
    weight("always_one", "you give 1", [](long double, long double) { return 1.0L; });
    weight("half", "you give a half", [](long double, long double) { return 0.5L; });
    // Others leave out what is far smaller, and are right where both are of one size.
    const auto all_or_nothing = [&](Weight other) {
        Symptom symptom =
            instead("the_larger_wins", "you give 1 where pdf is the larger one, and 0 where other is", other);
        symptom.where = [differs = symptom.where](const Case& q) {
            return differs(q) && ratio_of(q) > 0.3L && ratio_of(q) < 1 / 0.3L;
        };
        add(std::move(symptom));
    };
    all_or_nothing([](long double, long double q) { return q <= 1 ? 1.0L : 0.0L; });
    all_or_nothing([](long double, long double q) { return q < 1 ? 1.0L : 0.0L; });
    all_or_nothing([](long double, long double q) { return q < 1 ? 1.0L : q > 1 ? 0.0L : 0.5L; });
    add({"cutoff", "one density is smaller than the other, and you give exactly 0 for it, or 1 for the other",
         [](const WrongAnswer& w) {
             const long double ratio = ratio_of(w.question);
             return !is_infinite(w.question) && ratio != 0 && ratio != 1 && w.given[0] == (ratio < 1 ? 1 : 0);
         }});
    weight("no_square", "you give pdf / (pdf + other)", [](long double, long double q) { return 1 / (1 + q); });
    weight("swapped", "you give the weight of the other strategy",
           [](long double, long double q) { return q * q / (1 + q * q); });
    weight("swapped", "you give other / (pdf + other)", [](long double, long double q) { return q / (1 + q); });
    weight("sums_to_two", "you give twice what is right", [](long double, long double q) { return 2 / (1 + q * q); });
    weight("square_of_the_share", "you give the square of pdf / (pdf + other)",
           [](long double, long double q) { return 1 / ((1 + q) * (1 + q)); });
    const std::string one_above = "you give a square over plain densities";
    weight("only_one_squared", one_above, [](long double pdf, long double q) { return pdf / (1 + q); });
    weight("only_one_squared", one_above, [](long double pdf, long double q) { return pdf / std::sqrt(1 + q * q); });
    weight("one_square_below", "you give a plain density over squares",
           [](long double pdf, long double q) { return 1 / (pdf * (1 + q * q)); });
    weight("other_not_squared", "you give pdf^2 / (pdf^2 + other)",
           [](long double pdf, long double q) { return pdf / (pdf + q); });
    weight("other_not_squared", "you give pdf / (pdf + other^2)",
           [](long double pdf, long double q) { return 1 / (1 + q * q * pdf); });
    weight("power_of_three", "the densities are cubed", [](long double, long double q) { return 1 / (1 + q * q * q); });
    weight("power_of_three", "the densities are to the power of 4",
           [](long double, long double q) { return 1 / (1 + q * q * q * q); });
    const std::string rooted = "you give the root of what is right, or of the share";
    weight("root", rooted, [](long double, long double q) { return 1 / std::sqrt(1 + q * q); });
    weight("root", rooted, [](long double, long double q) { return 1 / std::sqrt(1 + q); });
    weight("reciprocal", "you give 1 over what is right", [](long double, long double q) { return 1 + q * q; });
    weight("ratio_alone", "you give the ratio of the squares", [](long double, long double q) { return 1 / (q * q); });
    weight("ratio_alone", "you give the ratio of the densities", [](long double, long double q) { return 1 / q; });
    weight("ratio_alone", "you give a ratio of the two, and 1 at most",
           [](long double, long double q) { return std::min(1.0L, 1 / (q * q)); });
    weight("ratio_alone", "you give a ratio of the two, and 1 at most",
           [](long double, long double q) { return std::min(1.0L, 1 / q); });
    for (const long double more : {1e-3L, 1e-4L, 1e-5L, 1e-6L, 1e-8L, 1e-9L, 1e-10L, 1e-12L, 1e-16L})
        all.push_back({"small_ones_are_nothing",
                       "a small number is added below, beside which small densities are nothing",
                       [more](const WrongAnswer& w) {
                           if (is_extreme(w.question)) return true;
                           const long double pdf = pdf_of(w.question), q = ratio_of(w.question);
                           const long double right = 1 / (1 + q * q), off = right - w.given[0];
                           const long double expected = right - pdf * pdf / (pdf * pdf * (1 + q * q) + more);
                           return std::abs(off - expected) < 0.01L * expected;  // it may be off by few digits only
                       }});
    return all;
}

}  // namespace raylab::grading::heuristic
