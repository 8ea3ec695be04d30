#pragma once

#include "questions.h"
#include "symptom.h"

// What wrong answers to this exercise have in common.

namespace raylab::grading::tree {

inline Arguments of(const Case& question) { return arguments(question.input); }

inline bool says_none(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 0; }
inline bool is_right_t(const WrongAnswer& w) {
    return w.right[0] == w.given[0] && (w.right[0] == 0 || agree(w.right[1], w.given[1]));
}

inline bool is_first_wasted(const WrongAnswer& w, Wasted::Why why) {
    const auto wasted = first_wasted(of(w.question), asked_of(w.given));
    return wasted && wasted->why == why;
}
inline bool wastes(const WrongAnswer& w) { return first_wasted(of(w.question), asked_of(w.given)).has_value(); }

/// The hit of the leaf that was asked first, second ... of those that have one.
inline std::vector<double> hits_in_order(const WrongAnswer& w) {
    std::vector<double> hits;
    const auto given = of(w.question);
    for (const int what : asked_of(w.given))
        if (given.is_leaf(what - leaf_mark))
            if (const auto t = hit_of(given, what - leaf_mark)) hits.push_back(*t);
    return hits;
}

inline bool gives_an_entry(const WrongAnswer& w) {
    const auto given = of(w.question);
    for (int node = 0; node < given.nodes(); ++node)
        if (const auto t = entry_of(given, node); t && w.given[0] == 1 && *t == w.given[1]) return true;
    return false;
}

inline std::size_t leaves_asked(const WrongAnswer& w) {
    return static_cast<std::size_t>(
        std::ranges::count_if(asked_of(w.given), [](int what) { return what >= leaf_mark; }));
}
/// Whether this node is opened: its things are asked for, or the box of a child.
inline bool opens(const WrongAnswer& w, int node) {
    return std::ranges::any_of(asked_of(w.given), [node](int what) {
        return what >= leaf_mark ? what - leaf_mark == node : what > 0 && (what - 1) / 2 == node;
    });
}

/// Whether a node that is entered before any hit is never opened, though the one above it was: one that is entered at
/// 0, or anywhere.
inline bool forgets_a_node(const WrongAnswer& w, bool at_zero) {
    const auto given = of(w.question);
    const auto nearest = truth(given);
    for (int node = 0; node < given.nodes(); ++node) {
        const auto entry = entry_of(given, node);
        if (!entry || (nearest && *entry >= *nearest) || (at_zero && *entry != 0)) continue;
        if ((node == 0 || opens(w, (node - 1) / 2)) && !opens(w, node)) return true;
    }
    return false;
}

/// Whether the ray begins in the root's box, so that it is entered at 0, and hits something.
inline bool begins_in_root(const Case& question) {
    const auto entry = entry_of(of(question), 0);
    return entry && *entry == 0 && truth(of(question));
}

/// Whether so often one child is entered before the other that an order by chance is hardly ever right.
inline bool has_choices(const Case& question) { return DepthFirst(of(question)).choices() >= 3; }

inline bool takes_the_later_first(const WrongAnswer& w) {
    const auto wasted = first_wasted(of(w.question), asked_of(w.given));
    if (!wasted || wasted->why != Wasted::Why::other_first) return false;
    const int open = wasted->asked >= leaf_mark ? wasted->asked - leaf_mark : (wasted->asked - 1) / 2;
    return opens(w, sibling_of(open));
}

/// Whether the hit that a right search finds first is not the nearest.
inline bool has_a_nearer_hit_later(const Case& question) {
    const auto given = of(question);
    const auto first = DepthFirst(given).first_hit();
    return first && *first > *truth(given);
}

/// Whether the hit that is given, if any, is one that was found, and none that was found is nearer.
inline bool gives_what_was_found(const WrongAnswer& w) {
    const auto hits = hits_in_order(w);
    return hits.empty() ? w.given[0] == 0 : w.given[0] == 1 && w.given[1] == std::ranges::min(hits);
}

inline bool never_asks_root(const WrongAnswer& w) { return std::ranges::count(asked_of(w.given), 0) == 0; }

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"root", "the tree is a single leaf, or the ray misses the root's box", [](const WrongAnswer& w) {
             return of(w.question).leaves() == 1 || (misses_root(of(w.question)) && never_asks_root(w));
         }});
    add({"none_is_no_number", "nothing is hit, and you give a number that is no t of anything",
         [](const WrongAnswer& w) {
             const auto hits = hits_in_order(w);
             return w.right[0] == 0 && w.given[0] == 1 && hits.empty() && !gives_an_entry(w);
         }});
    add({"entry_of_zero", "a box in which the ray begins, entered at 0, is never opened",
         [](const WrongAnswer& w) { return !wastes(w) && forgets_a_node(w, true); }, begins_in_root,
         [](const WrongAnswer& w) { return forgets_a_node(w, true); }});
    add({"far_away", "the hit is at a t of a thousand and more, and you give none",
         [](const WrongAnswer& w) { return says_none(w) && *truth(of(w.question)) > 1e3; },
         [](const Case& q) { return truth(of(q)).value_or(0) > 1e3; }, says_none});
    add({"every_leaf", "you ask for the things of all leaves",
         [](const WrongAnswer& w) { return leaves_asked(w) == static_cast<std::size_t>(of(w.question).leaves()); }});
    add({"asked_twice", "a question is asked that was asked before, and else all is right",
         [](const WrongAnswer& w) { return is_right_t(w) && is_first_wasted(w, Wasted::Why::twice); }});
    add({"missed_box", "you open a node whose box the ray misses",
         [](const WrongAnswer& w) { return is_first_wasted(w, Wasted::Why::missed); }});
    add({"entry_is_no_hit", "your t is where a box is entered, and no hit",
         [](const WrongAnswer& w) { return gives_an_entry(w) && !is_right_t(w); }});
    add({"order", "you open the child that is entered later before the other one", takes_the_later_first, has_choices,
         takes_the_later_first});
    add({"first_is_not_nearest", "the first hit that is found ends your search, and a nearer one lies in a later box",
         [](const WrongAnswer& w) {
             const auto hits = hits_in_order(w);
             return hits.size() == 1 && w.given[0] == 1 && w.right[0] == 1 && w.given[1] == hits.front();
         },
         has_a_nearer_hit_later});
    add({"farther_forgotten",
         "you never open a box that is entered before the hit",
         [](const WrongAnswer& w) {
             return forgets_a_node(w, false) && !takes_the_later_first(w) && gives_what_was_found(w);
         },
         {},
         [](const WrongAnswer& w) { return !wastes(w) && !is_right_t(w) && gives_what_was_found(w); }});
    add({"pruned_the_wrong_way",
         "you open what is entered beyond the nearest hit, and leave out what is entered before it",
         [](const WrongAnswer& w) {
             return is_first_wasted(w, Wasted::Why::beyond) && (!is_right_t(w) || forgets_a_node(w, false));
         },
         {},
         [](const WrongAnswer& w) {
             return is_first_wasted(w, Wasted::Why::beyond) || (!wastes(w) && !says_none(w));
         }});
    add({"early_end", "the hit is right, and you open what is entered beyond it", [](const WrongAnswer& w) {
             return is_right_t(w) && is_first_wasted(w, Wasted::Why::beyond) && !forgets_a_node(w, false);
         }});
    add({"level_by_level", "the hit is right, and you go on elsewhere before the nearer child is finished",
         [](const WrongAnswer& w) { return is_right_t(w) && !wastes(w) && w.given[2] > w.right[2]; }});
    add({"keep_the_nearer", "you give what the leaf had that was asked last, and not the nearest hit",
         [](const WrongAnswer& w) {
             const auto hits = hits_in_order(w);
             if (hits.empty() || is_right_t(w)) return false;
             return says_none(w) || (hits.size() > 1 && w.given[0] == 1 && w.given[1] == hits.back());
         }});
    add({"keep_the_nearer", "you give a hit that is farther than another one that you found", [](const WrongAnswer& w) {
             const auto hits = hits_in_order(w);
             return !hits.empty() && w.given[0] == 1 && std::ranges::find(hits, w.given[1]) != hits.end() &&
                    w.given[1] > std::ranges::min(hits);
         }});
    add({"early_end",
         "the hit is right, and you open what is not worth it: beyond the hit, or the later child first",
         [](const WrongAnswer& w) { return is_right_t(w) && is_first_wasted(w, Wasted::Why::beyond); },
         {},
         [](const WrongAnswer& w) { return is_right_t(w) && is_first_wasted(w, Wasted::Why::other_first); }});
    add({"farther_forgotten", "you give none where there is a hit, and nothing in a later box was asked for",
         [](const WrongAnswer& w) { return says_none(w) && !wastes(w) && gives_what_was_found(w); }});
    add({"farther_forgotten", "you stop before all boxes are opened that are entered before the hit",
         [](const WrongAnswer& w) { return !is_right_t(w) && !wastes(w) && gives_what_was_found(w); }});
    return of_numbers(std::move(all), {"none_is_no_number"});
}

}  // namespace raylab::grading::tree
