#pragma once

#include "questions.h"
#include "symptom.h"

#include <functional>
#include <limits>
#include <utility>

// What wrong answers to this exercise have in common: they decide by another number than what a branch can bring.

namespace raylab::grading::branches {

inline Arguments of(const Case& question) { return arguments(question.input); }

inline bool is_given(const WrongAnswer& w, const FollowedBranches& other) {
    const auto is = [](double given, double value) { return given == value || agree(given, value); };
    return is(w.given[0], other.reflected) && is(w.given[1], other.transmitted);
}

inline Symptom instead(const std::string& hint, const std::string& words,
                       const std::function<FollowedBranches(const Arguments&)>& other) {
    return {hint, words, [other](const WrongAnswer& w) { return is_given(w, other(of(w.question))); },
            [other](const Case& question) {  // in which it is not what is right
                const auto [reflected, transmitted] = truth(of(question));
                const auto found = other(of(question));
                return found.reflected != reflected || found.transmitted != transmitted;
            }};
}

/// A branch with this share is followed where this is more than the least; its weight is right.
using Brings = std::function<double(const Arguments&, double share)>;
inline Symptom decides_by(const std::string& hint, const std::string& words, const Brings& brings) {
    return instead(hint, words, [brings](const Arguments& given) {
        const auto weight = [&](double share) { return brings(given, share) > given.least ? given.weight * share : 0; };
        return FollowedBranches{weight(given.reflected), weight(given.transmitted)};
    });
}

/// Right but for the number that stands for the series.
inline Symptom by_series(const std::string& hint, const std::string& words, double (*other)(const Arguments&)) {
    return decides_by(hint, words, [other](const Arguments& given, double share) {
        return given.weight * share * given.brightest * other(given);
    });
}

inline double endless(double rho) { return rho < 1 ? 1 / (1 - rho) : std::numeric_limits<double>::infinity(); }

/// The decision for both branches is that of this share.
inline Symptom both_by(const std::string& words, double (*share_of)(const Arguments&)) {
    return instead("each_by_itself", words, [share_of](const Arguments& given) {
        if (!(most(given, share_of(given)) > given.least)) return FollowedBranches{};
        return FollowedBranches{given.weight * given.reflected, given.weight * given.transmitted};
    });
}

/// What is not followed may be lost once: what one branch has lost is taken off the least of the other.
enum class Order { mirrored_first, refracted_first, weaker_first };
inline FollowedBranches by_what_is_left(const Arguments& given, Order order) {
    const bool is_reflected_weaker = given.reflected <= given.transmitted;
    const bool begins_mirrored =
        order == Order::mirrored_first || (order == Order::weaker_first && is_reflected_weaker);
    double left = given.least;
    const auto weight = [&](double share) {
        if (most(given, share) > left) return given.weight * share;
        left -= most(given, share);
        return 0.0;
    };
    const double first = weight(begins_mirrored ? given.reflected : given.transmitted),
                 second = weight(begins_mirrored ? given.transmitted : given.reflected);
    return begins_mirrored ? FollowedBranches{first, second} : FollowedBranches{second, first};
}

inline void add_weights(std::vector<Symptom>& all) {
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto made = [&](const std::string& hint, const std::string& words,
                          double (*value)(const Arguments&, double share)) {
        add(instead(hint, words, [value](const Arguments& given) {
            const auto of_branch = [&](double share) { return weight_of(given, share) > 0 ? value(given, share) : 0; };
            return FollowedBranches{of_branch(given.reflected), of_branch(given.transmitted)};
        }));
    };
    made("give_the_weight", "you give the surface's share", [](const Arguments&, double share) { return share; });
    made("give_the_weight", "you give 1 for what is followed", [](const Arguments&, double) { return 1.0; });
    made("give_the_weight", "you give the weight of the ray that arrives",
         [](const Arguments& given, double) { return given.weight; });
    made("give_the_weight", "you give what the branch can bring at most", most);
    made("give_the_weight", "you give a weight that has rho in it",
         [](const Arguments& given, double share) { return given.weight * share * given.largest_share; });
    made("give_the_weight", "you give a weight that has the brightest colour in it",
         [](const Arguments& given, double share) { return given.weight * share * given.brightest; });
    add(instead("each_keeps_its_own", "a branch that is followed alone has the other's weight as well",
                [](const Arguments& given) {
                    auto found = truth(given);
                    const double both = given.weight * (given.reflected + given.transmitted);
                    if (found.transmitted == 0 && found.reflected > 0)
                        found.reflected = both;
                    else if (found.reflected == 0 && found.transmitted > 0)
                        found.transmitted = both;
                    return found;
                }));
    add(instead("exchanged", "the two weights have changed places", [](const Arguments& given) {
        const auto [reflected, transmitted] = truth(given);
        return FollowedBranches{transmitted, reflected};
    }));
    add(instead("turned", "you follow what is not worth it, and nothing else", [](const Arguments& given) {
        const auto turned = [&](double share) { return weight_of(given, share) > 0 ? 0 : given.weight * share; };
        return FollowedBranches{turned(given.reflected), turned(given.transmitted)};
    }));
}

inline void add_series(std::vector<Symptom>& all) {
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add(by_series("count_the_levels", "you count one level too many",
                  [](const Arguments& given) { return series(given.largest_share, given.levels + 1); }));
    add(by_series("count_the_levels", "you count one level too few",
                  [](const Arguments& given) { return series(given.largest_share, given.levels - 1); }));
    add(by_series("endless", "you decide by L / (1 - rho), as if there were no last level",
                  [](const Arguments& given) { return endless(given.largest_share); }));
    add(by_series("endless", "you decide by L / (1 - rho) while a level is left, as if there were no last one",
                  [](const Arguments& given) { return given.levels > 0 ? endless(given.largest_share) : 0; }));
    add(by_series("endless", "you decide by L / (1 - rho), but where rho is 1: as if there were no last level",
                  [](const Arguments& given) {
                      return given.largest_share < 1 ? endless(given.largest_share) : double(given.levels);
                  }));
    add(decides_by("twice_as_much", "you decide as if the least were shared out among the levels",
                   [](const Arguments& given, double share) { return most(given, share) * given.levels; }));
    add(by_series("rho_is_of_both", "the terms are (2 rho)^i: the rays' number is in them as well",
                  [](const Arguments& given) { return series(2 * given.largest_share, given.levels); }));
    add(by_series("undivided", "you decide by 1 - rho^n, which is not divided by 1 - rho",
                  [](const Arguments& given) { return 1 - std::pow(given.largest_share, given.levels); }));
    add(decides_by("counted_twice", "the arriving ray's weight counts twice",
                   [](const Arguments& given, double share) { return most(given, share) * given.weight; }));
    add(decides_by("counted_twice", "the branch's share counts twice",
                   [](const Arguments& given, double share) { return most(given, share) * share; }));
    add(decides_by("counted_twice", "the brightest colour counts twice",
                   [](const Arguments& given, double share) { return most(given, share) * given.brightest; }));
    add(by_series("twice_as_much", "you decide as if each branch could bring twice what it can",
                  [](const Arguments& given) { return 2 * series(given.largest_share, given.levels); }));
    add(decides_by("whose_rho", "you take this branch's share for those of all surfaces",
                   [](const Arguments& given, double share) {
                       return given.weight * share * given.brightest * series(share, given.levels);
                   }));
    add(decides_by("whose_rho", "you take the other branch's share for those of all surfaces",
                   [](const Arguments& given, double share) {
                       const double other = share == given.reflected ? given.transmitted : given.reflected;
                       return given.weight * share * given.brightest * series(other, given.levels);
                   }));
    add(by_series(
        "whose_rho", "you take this surface's larger share for those of all surfaces",
        [](const Arguments& given) { return series(std::max(given.reflected, given.transmitted), given.levels); }));
    add(by_series("one_level", "you decide by what the next surface alone can bring",
                  [](const Arguments& given) { return given.levels > 0 ? 1.0 : 0.0; }));
    add(by_series("one_level", "you decide by what the next surface alone can bring, even where no level is left",
                  [](const Arguments&) { return 1.0; }));
    add(by_series(
        "first_term", "the series begins with rho: what the next surface shows by itself is missing",
        [](const Arguments& given) { return given.largest_share * series(given.largest_share, given.levels); }));
    add(by_series("last_term", "you decide by what the last level alone can bring", [](const Arguments& given) {
        return given.levels > 0 ? std::pow(given.largest_share, given.levels - 1) : 0.0;
    }));
    add(by_series("last_term", "you decide by rho to the power of the levels",
                  [](const Arguments& given) { return std::pow(given.largest_share, given.levels); }));
    add(by_series(
        "last_term", "you decide by rho to the power of the levels, while one is left",
        [](const Arguments& given) { return given.levels > 0 ? std::pow(given.largest_share, given.levels) : 0.0; }));
    add(by_series("every_level_alike", "every level brings as much as the first",
                  [](const Arguments& given) { return static_cast<double>(given.levels); }));
    for (const double nearly : {0.99, 0.999, 0.9})
        add(decides_by("every_level_alike", "where rho is nearly 1 every level brings as much as the first",
                       [nearly](const Arguments& given, double share) {
                           const double rho = given.largest_share > nearly ? 1 : given.largest_share;
                           return given.weight * share * given.brightest * series(rho, given.levels);
                       }));
    for (const double epsilon : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
        add(decides_by("own_least", "you add up no more levels once one brings less than a small number of yours",
                       [epsilon](const Arguments& given, double share) {
                           double sum = 0, term = given.brightest;
                           for (int i = 0; i < given.levels && term > epsilon; ++i, term *= given.largest_share)
                               sum += term;
                           return given.weight * share * sum;
                       }));
    add({"own_least", "the scene is dim, or the ray is faint, and you follow too little", [](const WrongAnswer& w) {
             const auto given = of(w.question);
             return (given.brightest < 1e-3 || given.weight < 1e-3) && w.given[0] <= w.right[0] &&
                    w.given[1] <= w.right[1];
         }});
    add(by_series("whose_rho", "you take this surface's shares for those of all surfaces",
                  [](const Arguments& given) { return series(given.reflected + given.transmitted, given.levels); }));
    add(by_series("whose_rho", "you take this surface's shares for those of all surfaces, and no level for the last",
                  [](const Arguments& given) { return endless(given.reflected + given.transmitted); }));
}

/// Where even a rho of .9999 brings less than 1 does: by more than a hundredth.
inline bool is_one_with_many_levels(const Case& question) {
    return of(question).largest_share == 1 && of(question).levels >= 200;
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto all_is_mirrored = [](const Case& question) { return of(question).largest_share == 1; };
    add({"rho_is_one", "rho is 1, where (1 - rho^n) / (1 - rho) is 0 / 0",
         [](const WrongAnswer& w) { return of(w.question).largest_share == 1; }, all_is_mirrored});
    add({"rho_is_one", "rho is 1 and many levels are left, and you follow too little: as if rho were a little less",
         [](const WrongAnswer& w) {
             return is_one_with_many_levels(w.question) && w.given[0] <= w.right[0] && w.given[1] <= w.right[1];
         },
         is_one_with_many_levels});
    add({"no_level_left", "no level is left, and you follow a ray",
         [](const WrongAnswer& w) { return of(w.question).levels == 0 && (w.given[0] > 0 || w.given[1] > 0); },
         [](const Case& question) { return of(question).levels == 0; }});
    add({"more_than_the_least", "a branch can bring the least and no more, and you follow it",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             const auto tie = [&](double share) { return share > 0 && most(given, share) == given.least; };
             return tie(given.reflected) || tie(given.transmitted);
         }});
    add_weights(all);
    add_series(all);
    add(both_by("both branches are followed by what they bring together",
                [](const Arguments& given) { return given.reflected + given.transmitted; }));
    add(both_by("both branches are followed where one of them is",
                [](const Arguments& given) { return std::max(given.reflected, given.transmitted); }));
    add(both_by("neither branch is followed where one of them is not",
                [](const Arguments& given) { return std::min(given.reflected, given.transmitted); }));
    for (const Order order : {Order::mirrored_first, Order::refracted_first, Order::weaker_first})
        add(instead("each_by_itself", "what one branch has lost is taken off the least of the other",
                    [order](const Arguments& given) { return by_what_is_left(given, order); }));
    add(instead("each_by_itself", "the one branch is followed only where the other is not", [](const Arguments& given) {
        auto found = truth(given);
        if (found.reflected > 0) found.transmitted = 0;
        return found;
    }));
    add(instead("each_by_itself", "only the stronger branch is followed", [](const Arguments& given) {
        auto found = truth(given);
        (given.reflected < given.transmitted ? found.reflected : found.transmitted) = 0;
        return found;
    }));
    add(decides_by("weight_alone", "you compare the weight alone, whatever its colour may be",
                   [](const Arguments& given, double share) { return given.levels > 0 ? given.weight * share : 0; }));
    add(decides_by("weight_alone", "you compare the weight alone, whatever its colour may be",
                   [](const Arguments& given, double share) { return given.weight * share; }));
    add(instead("weight_alone", "you follow nothing where the arriving ray's weight is less than the least",
                [](const Arguments& given) { return given.weight < given.least ? FollowedBranches{} : truth(given); }));
    for (const bool is_either : {true, false})
        add(instead(
            "weight_alone",
            is_either ? "you follow no branch whose weight is less than the least, whatever its colour may be"
                      : "you follow every branch whose weight is more than the least, whatever its colour may be",
            [is_either](const Arguments& given) {
                const auto weight = [&](double share) {
                    const bool heavy = given.weight * share > given.least, worth = weight_of(given, share) > 0;
                    return (is_either ? heavy && worth : (heavy && given.levels > 0) || worth) ? given.weight * share
                                                                                               : 0;
                };
                return FollowedBranches{weight(given.reflected), weight(given.transmitted)};
            }));
    add(decides_by("brightest", "you decide as if the brightest colour were 1",
                   [](const Arguments& given, double share) { return most(given, share) / given.brightest; }));
    add(decides_by(
        "brightest", "you decide as if no colour could be brighter than 1",
        [](const Arguments& given, double share) { return most(given, share) / std::max(1.0, given.brightest); }));
    add(decides_by(
        "brightest", "you decide as if there were always a colour as bright as 1",
        [](const Arguments& given, double share) { return most(given, share) / std::min(1.0, given.brightest); }));
    add(decides_by("weight_of_the_way", "the weight of the ray that arrives does not count",
                   [](const Arguments& given, double share) { return most(given, share) / given.weight; }));
    add(decides_by("share_of_the_branch", "the branch's share does not count",
                   [](const Arguments& given, double share) { return share > 0 ? most(given, 1) : 0; }));
    add(decides_by("depth_alone", "you follow everything while a level is left",
                   [](const Arguments& given, double share) {
                       return given.levels > 0 && share > 0 ? std::numeric_limits<double>::infinity() : 0;
                   }));
    return of_numbers(std::move(all), {"rho_is_one"});
}

}  // namespace raylab::grading::branches
