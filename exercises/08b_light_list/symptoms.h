#pragma once

#include "questions.h"
#include "symptom.h"

#include <functional>
#include <numeric>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::light_list {

inline Arguments of(const Case& question) { return arguments(question.input); }

inline bool is_share(const WrongAnswer& w, double share) { return std::abs(w.given[0] - share) <= 1e-11; }
inline bool is_right_share(const WrongAnswer& w) { return is_share(w, w.right[0]); }

inline bool wastes(const WrongAnswer& w, Wasted::Why why) {
    const auto wasted = first_wasted(of(w.question), asked_of(w.given));
    return wasted && wasted->why == why;
}
inline bool wastes_nothing(const WrongAnswer& w) { return !first_wasted(of(w.question), asked_of(w.given)); }

/// The shares of the entries in the way, from the light on.
inline std::vector<double> shares_of(const Arguments& given) {
    std::vector<double> shares;
    for (int i = 0; i < reached(given); ++i) shares.push_back(given.entries[static_cast<std::size_t>(i)].through);
    return shares;
}

inline double product(std::span<const double> shares) {
    return std::accumulate(shares.begin(), shares.end(), 1.0, std::multiplies<>());
}

/// The answer is this of those shares.
inline Symptom instead(const std::string& hint, const std::string& words,
                       const std::function<double(const std::vector<double>& shares)>& other) {
    return {hint, words,
            [other](const WrongAnswer& w) {
                const auto shares = shares_of(of(w.question));
                return !shares.empty() && !is_right_share(w) && is_share(w, other(shares));
            },
            [other](const Case& question) {  // in which it is not what is right
                const auto given = of(question);
                const auto shares = shares_of(given);
                return !shares.empty() && !is_behind_what_fills(given) && std::abs(other(shares) - truth(given)) > 1e-9;
            }};
}

/// Something in the way dims the light, and the list goes on beyond the point.
inline bool is_dimmed_before_the_end(const Case& question) {
    const auto given = of(question);
    const double share = truth(given);
    return 0 < share && share < 1 && reached(given) < given.count();
}

inline void add_values(std::vector<Symptom>& all) {
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add(instead("multiply", "the darkest pane counts alone",
                [](const auto& shares) { return *std::ranges::min_element(shares); }));
    add(instead("multiply", "what the panes hold back is added up", [](const auto& shares) {
        double left = 1;
        for (const double share : shares) left -= 1 - share;
        return left;
    }));
    add(instead("multiply", "what the panes hold back is added up, down to nothing", [](const auto& shares) {
        double left = 1;
        for (const double share : shares) left -= 1 - share;
        return std::max(0.0, left);
    }));
    add(instead("multiply", "the shares are squared", [](const auto& shares) {
        const double passes = product(shares);
        return passes * passes;
    }));
    add(instead("multiply", "each share is mixed with what was left, half of each", [](const auto& shares) {
        double left = 1;
        for (const double share : shares) left = share == 0 || left == 0 ? 0 : (left + share) / 2;
        return left;
    }));
    add(instead("multiply", "it is the mean of the shares", [](const auto& shares) {
        return std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
    }));
    add(instead("multiply", "it is the mean of the shares, but where one of them is 0", [](const auto& shares) {
        if (std::ranges::find(shares, 0.0) != shares.end()) return 0.0;
        return std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
    }));
    add(instead("multiply", "the shares are added up",
                [](const auto& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }));
    add(instead("multiply", "the last entry that was tested counts alone", [](const auto& shares) {
        const auto dark = std::ranges::find(shares, 0.0);
        return dark != shares.end() ? 0 : shares.back();
    }));
    add(instead("held_back", "you give what is held back", [](const auto& shares) { return 1 - product(shares); }));
    add(instead("glass_lets_through", "glass is as opaque as brick", [](const auto& shares) {
        return std::ranges::all_of(shares, [](double share) { return share == 1; }) ? 1.0 : 0.0;
    }));
    add(instead("glass_dims", "glass counts as if it were not there", [](const auto& shares) {
        return std::ranges::all_of(shares, [](double share) { return share > 0; }) ? 1.0 : 0.0;
    }));
    add(instead("opaque_is_dark", "what got through before the first opaque entry is the answer",
                [](const auto& shares) {
                    const auto dark = std::ranges::find(shares, 0.0);
                    return product(std::span(shares).first(static_cast<std::size_t>(dark - shares.begin())));
                }));
    add(instead("go_on_behind_glass", "the first pane that is hit ends the search", [](const auto& shares) {
        const auto hit = std::ranges::find_if(shares, [](double share) { return share < 1; });
        return hit == shares.end() ? 1.0 : *hit;
    }));
    const auto but_for_the_last = [](const Case& question) {  // of the list, not of those in the way
        const auto given = of(question);
        auto shares = shares_of(given);
        if (!shares.empty() && static_cast<int>(shares.size()) == given.count()) shares.pop_back();
        return is_behind_what_fills(given) ? 0 : product(shares);
    };
    add({"every_entry", "the list's last entry does not count",
         [=](const WrongAnswer& w) { return !is_right_share(w) && is_share(w, but_for_the_last(w.question)); },
         [=](const Case& q) { return std::abs(but_for_the_last(q) - truth(of(q))) > 1e-9; }});
    add(instead("every_entry", "the last entry in the way does not count",
                [](const auto& shares) { return product(std::span(shares).first(shares.size() - 1)); }));
    add(instead("every_entry", "the first entry does not count",
                [](const auto& shares) { return product(std::span(shares).subspan(1)); }));
    add(instead("miss_is_no_end", "the first entry that is missed ends the search", [](const auto& shares) {
        const auto missed = std::ranges::find(shares, 1.0);
        return product(std::span(shares).first(static_cast<std::size_t>(missed - shares.begin())));
    }));
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto is_lit = [](const Case& q) { return truth(of(q)) > 0; };
    add({"begins_with_one", "light arrives, and you say that it is dark",
         [is_lit](const WrongAnswer& w) { return is_lit(w.question) && w.given[0] == 0; },
         [is_lit](const Case& q) { return is_lit(q); },
         [](const WrongAnswer& w) { return w.given[0] == 0 && wastes(w, Wasted::Why::dark); }});
    const auto wasted = [&](const std::string& hint, const std::string& words, Wasted::Why why) {
        add({hint, words, [why](const WrongAnswer& w) { return wastes(w, why); }});
    };
    add({"on_what_fills", "the point lies on what fills the cell, and you say that it is dark",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             return given.depth == given.filled && w.given[0] == 0 && w.given[1] == 0;
         }});
    add({"as_deep", "an entry begins exactly as deep as the point, and is not tested", [](const WrongAnswer& w) {
             const auto given = of(w.question);
             const auto asked = asked_of(w.given);
             for (int i = 0; i < reached(given); ++i)
                 if (given.entry(i)->begin == given.depth && std::ranges::count(asked, i) == 0)
                     return wastes_nothing(w);
             return false;
         }});
    // Who says so wherever some light is left has another fault than the end of the search.
    add({"what_is_left", "what was in the way before the search ended is forgotten: you say that all light arrives",
         [](const WrongAnswer& w) { return w.given[0] == 1 && is_dimmed_before_the_end(w.question); },
         is_dimmed_before_the_end});
    add({"what_is_left", "the search ends at an entry beyond the point, and you say that it is dark",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             return w.right[0] > 0 && w.given[0] == 0 && reached(given) < given.count();
         },
         [](const Case& q) { return truth(of(q)) > 0 && reached(of(q)) < of(q).count(); }});
    // Less than any single pane leaves.
    add({"hardly_dark", "little light is left, and you say that there is none, or test no further",
         [](const WrongAnswer& w) {
             const auto shares = shares_of(of(w.question));
             const auto asked = asked_of(w.given);
             if (!(w.right[0] > 0 && w.right[0] < 0.2) || asked.size() > shares.size()) return false;
             if (w.given[0] == 0) return true;
             const auto first = std::span(shares).first(asked.size());
             return first.size() < shares.size() && w.given[0] < 0.2 && is_share(w, product(first));
         }});
    wasted("past_the_end", "you ask for an entry that there is not", Wasted::Why::stranger);
    wasted("once_each", "an entry is tested again", Wasted::Why::twice);
    wasted("filled_first", "the point is behind what fills the cell, and you test entries", Wasted::Why::filled);
    wasted("dark_is_dark", "nothing is left of the light, and you test on", Wasted::Why::dark);
    wasted("ends_at_the_point", "you test what begins deeper than the point", Wasted::Why::beyond);
    add({"every_entry", "the entry with the number 0 is not tested, and the next one is", [](const WrongAnswer& w) {
             const auto asked = asked_of(w.given);
             return !asked.empty() && asked.front() == 1 && std::ranges::count(asked, 0) == 0;
         }});
    add({"every_entry", "you go on in the list's order, and leave out an entry in the way", [](const WrongAnswer& w) {
             const auto asked = asked_of(w.given);
             return asked.size() > 1 && std::ranges::is_sorted(asked) && wastes(w, Wasted::Why::out_of_order);
         }});
    wasted("nearest_first", "you test an entry before one that begins nearer to the light", Wasted::Why::out_of_order);
    // Where the list is as dark as what fills the cell, only the tests tell.
    add({"filled_first", "the point is behind what fills the cell, and you say that light comes to it, or ask the list",
         [](const WrongAnswer& w) {
             return is_behind_what_fills(of(w.question)) && (w.given[0] != 0 || wastes(w, Wasted::Why::filled));
         }});
    add({"before_what_fills", "the point is before what fills the cell, and you say that it is dark",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             return given.filled != none_fills && !is_behind_what_fills(given) && w.given[0] == 0 && w.given[1] == 0;
         }});
    add({"few_digits", "the share is right to some seven digits", [](const WrongAnswer& w) {
             return wastes_nothing(w) && std::abs(w.given[0] - w.right[0]) < 1e-6 * w.right[0];
         }});
    add_values(all);
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::light_list
