#pragma once

#include "symptom.h"
#include "truth.h"

#include <cmath>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::cuts {

inline SahCut of(const Case& question) { return arguments(question.input); }
inline double surface_of(const Vec3d& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }
inline bool no_area(const Case& question) { return surface_of(of(question).size) == 0; }
inline bool one_is_empty(const SahCut& cut) { return cut.below == 0 || cut.above == 0; }

inline bool is_at_a_side(const SahCut& cut) { return cut.place == 0 || cut.place == cut.size[cut.axis]; }

/// A cut's cost by the shares of rays that hit each half.
struct Shares {
    double below, above;
};
inline Shares shares(const SahCut& cut) {
    Vec3d below = cut.size, above = cut.size;
    below[cut.axis] = cut.place;
    above[cut.axis] = cut.size[cut.axis] - cut.place;
    return {surface_of(below) / surface_of(cut.size), surface_of(above) / surface_of(cut.size)};
}
inline double saved(const SahCut& cut) { return one_is_empty(cut) ? 1 - cut.empty_bonus : 1; }
inline double tests(const SahCut& cut, Shares s) { return cut.test_cost * (s.below * cut.below + s.above * cut.above); }
inline double cost(const SahCut& cut, Shares s) { return cut.visit_cost + saved(cut) * tests(cut, s); }

/// The cost is this one, wherever the cell has an area.
inline Symptom instead(const std::string& hint, const std::string& words, double (*other)(const SahCut&)) {
    return {hint, words, [other](const WrongAnswer& w) { return agree(w.given[0], other(of(w.question))); }};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"no_area", "the cell has no area at all", [](const WrongAnswer& w) { return no_area(w.question); }});
    add({"flat_cells", "the cell is flat, and still has two sides", [](const WrongAnswer& w) {
             const auto size = of(w.question).size;
             return size.x == 0 || size.y == 0 || size.z == 0;
         }});
    add({"flat_cells", "the plane is a side of the cell, so that a half is flat, and you give infinity",
         [](const WrongAnswer& w) { return is_at_a_side(of(w.question)) && std::isinf(w.given[0]); }});
    add({"absolute_epsilon", "the cell is smaller than a millimetre, and you give infinity", [](const WrongAnswer& w) {
             return surface_of(of(w.question).size) < 1e-6 && std::isinf(w.given[0]) && !std::isinf(w.right[0]);
         }});
    add({"absolute_epsilon", "the cell is smaller than a millimetre",
         [](const WrongAnswer& w) { return surface_of(of(w.question).size) < 1e-6; }});
    add({"chance_of_the_full", "one half is empty, and all rays pay for what is in the other",
         [](const WrongAnswer& w) {
             const SahCut c = of(w.question);
             return one_is_empty(c) && agree(w.given[0], cost(c, {1, 1}));
         },
         [](const Case& q) { return one_is_empty(of(q)) && !no_area(q); }});
    add({"bonus_when", "the lower half is empty", [](const WrongAnswer& w) { return of(w.question).below == 0; },
         [](const Case& q) { return of(q).below == 0 && !no_area(q); }});
    add({"bonus_when", "the upper half is empty", [](const WrongAnswer& w) { return of(w.question).above == 0; },
         [](const Case& q) { return of(q).above == 0 && !no_area(q); }});
    auto for_thin_half = instead(
        "bonus_when", "the bonus is given where the plane is a side of the cell",
        [](const SahCut& c) { return c.visit_cost + (is_at_a_side(c) ? 1 - c.empty_bonus : 1) * tests(c, shares(c)); });
    for_thin_half.where = [](const Case& q) { return is_at_a_side(of(q)) && !no_area(q) && !one_is_empty(of(q)); };
    for_thin_half.allows = for_thin_half.shows;  // elsewhere it is as if the bonus were forgotten
    add(for_thin_half);
    add(instead("visit_forgotten", "the visit's cost is missing",
                [](const SahCut& c) { return cost(c, shares(c)) - c.visit_cost; }));
    add(instead("visit_twice", "the visit is paid for each half",
                [](const SahCut& c) { return cost(c, shares(c)) + c.visit_cost; }));
    add(instead("visit_twice", "each half's visit is paid by the rays that hit it, and not the node's by all",
                [](const SahCut& c) {
                    const auto [below, above] = shares(c);
                    return cost(c, {below, above}) + (below + above - 1) * c.visit_cost;
                }));
    add(instead("visit_twice", "each half's visit is paid by the rays that hit it, and saved with the tests",
                [](const SahCut& c) {
                    const auto [below, above] = shares(c);
                    return saved(c) * (tests(c, {below, above}) + (below + above) * c.visit_cost);
                }));
    add(instead("visit_twice", "each half's visit is paid, beside the node's own", [](const SahCut& c) {
        const auto [below, above] = shares(c);
        return cost(c, {below, above}) + (below + above) * c.visit_cost;
    }));
    add(instead("bonus_of_tests", "the bonus is taken off the visit, too",
                [](const SahCut& c) { return saved(c) * (c.visit_cost + tests(c, shares(c))); }));
    add(instead("bonus_of_tests", "the bonus is taken off the visit, and not off the tests",
                [](const SahCut& c) { return saved(c) * c.visit_cost + tests(c, shares(c)); }));
    add(instead("bonus_forgotten", "one side is empty, and nothing is saved",
                [](const SahCut& c) { return c.visit_cost + tests(c, shares(c)); }));
    add(instead("bonus_saves", "the bonus is what is left, not what is saved", [](const SahCut& c) {
        return c.visit_cost + (one_is_empty(c) ? c.empty_bonus : 1) * tests(c, shares(c));
    }));
    add(instead("bonus_saves", "the tests' cost is divided by 1 + empty_bonus", [](const SahCut& c) {
        return c.visit_cost + tests(c, shares(c)) / (one_is_empty(c) ? 1 + c.empty_bonus : 1);
    }));
    add(instead("bonus_saves", "the bonus is added", [](const SahCut& c) {
        return c.visit_cost + (one_is_empty(c) ? 1 + c.empty_bonus : 1) * tests(c, shares(c));
    }));
    add(instead("bonus_saves", "the bonus is taken off as a number, not as a share", [](const SahCut& c) {
        return c.visit_cost + tests(c, shares(c)) - (one_is_empty(c) ? c.empty_bonus : 0);
    }));
    add(instead("bonus_when", "the bonus is given wherever no side is empty, too",
                [](const SahCut& c) { return c.visit_cost + (1 - c.empty_bonus) * tests(c, shares(c)); }));
    add(instead("sides_swapped", "each half's things are multiplied by the other half's area", [](const SahCut& c) {
        return cost(c, {shares(c).above, shares(c).below});
    }));
    add(instead("by_volume", "the shares are those of volumes, or of lengths along the axis", [](const SahCut& c) {
        const double below = c.place / c.size[c.axis];
        return cost(c, {below, 1 - below});
    }));
    add(instead("not_divided", "the areas are not divided by the cell's", [](const SahCut& c) {
        const double area = surface_of(c.size);
        return cost(c, {shares(c).below * area, shares(c).above * area});
    }));
    add(instead("not_divided", "the areas are not divided by the cell's", [](const SahCut& c) {
        const double area = 2 * surface_of(c.size);
        return cost(c, {shares(c).below * area, shares(c).above * area});
    }));
    add(instead("halves_of_area", "one area is a whole surface, the other half of one", [](const SahCut& c) {
        return cost(c, {2 * shares(c).below, 2 * shares(c).above});
    }));
    add(instead("halves_of_area", "one area is a whole surface, the other half of one", [](const SahCut& c) {
        return cost(c, {shares(c).below / 2, shares(c).above / 2});
    }));
    const std::string one_of_two = "one half's area is half of a surface, or a whole one where all others are halves";
    for (const double times : {2.0, 0.5}) {
        add({"halves_of_area", one_of_two, [times](const WrongAnswer& w) {
                 const SahCut c = of(w.question);
                 return agree(w.given[0], cost(c, {times * shares(c).below, shares(c).above}));
             }});
        add({"halves_of_area", one_of_two, [times](const WrongAnswer& w) {
                 const SahCut c = of(w.question);
                 return agree(w.given[0], cost(c, {shares(c).below, times * shares(c).above}));
             }});
    }
    for (const double chance : {0.5, 1.0}) {
        add({"half_for_each",
             chance == 1 ? "each half is hit by all rays"
                         : "each half is hit by half of all rays, wherever the plane stands",
             [chance](const WrongAnswer& w) {
                 return agree(w.given[0], cost(of(w.question), {chance, chance}));
             },
             [](const Case& q) { return !one_is_empty(of(q)) && !no_area(q); }});
        all.back().allows = all.back().shows;  // whoever does it where one half is empty alone thinks otherwise
    }
    add(instead("test_cost", "a test costs 1, whatever test_cost is", [](const SahCut& c) {
        SahCut other = c;
        other.test_cost = 1;
        return cost(other, shares(c));
    }));
    add(instead("test_cost", "a test costs as much as the visit", [](const SahCut& c) {
        SahCut other = c;
        other.test_cost = c.visit_cost;
        return cost(other, shares(c));
    }));
    add(instead("test_cost", "the visit costs as much as a test", [](const SahCut& c) {
        SahCut other = c;
        other.visit_cost = c.test_cost;
        return cost(other, shares(c));
    }));
    add(instead("test_cost", "visit and test have changed their costs", [](const SahCut& c) {
        SahCut other = c;
        std::swap(other.test_cost, other.visit_cost);
        return cost(other, shares(c));
    }));
    for (const int axis : {0, 1, 2})
        add({"always_x", "the cell is cut along another axis than cut.axis", [axis](const WrongAnswer& w) {
                 SahCut cut = of(w.question);
                 if (cut.axis == axis) return false;
                 cut.axis = axis;
                 return agree(w.given[0], cost(cut, shares(cut)));
             }});
    const std::string shorter = "one half, or both, is shorter along all three axes, and not along cut.axis alone";
    add(instead("one_axis", shorter, [](const SahCut& c) {
        return cost(c, {shares(c).below, surface_of(c.size - c.place) / surface_of(c.size)});
    }));
    add(instead("one_axis", shorter, [](const SahCut& c) {
        return cost(c, {surface_of(Vec3d(c.place)) / surface_of(c.size), shares(c).above});
    }));
    add(instead("one_axis", shorter, [](const SahCut& c) {
        return cost(
            c, {surface_of(Vec3d(c.place)) / surface_of(c.size), surface_of(c.size - c.place) / surface_of(c.size)});
    }));
    add(instead("one_axis", shorter, [](const SahCut& c) {
        const double share = c.place / c.size[c.axis];
        return cost(c, {share * share, (1 - share) * (1 - share)});
    }));
    add(instead("cut_face", "the face that the cut makes is missing", [](const SahCut& c) {
        const double face = c.size[(c.axis + 1) % 3] * c.size[(c.axis + 2) % 3], area = surface_of(c.size);
        return cost(c, {shares(c).below - face / 2 / area, shares(c).above - face / 2 / area});
    }));
    add(instead("cut_face", "of both halves the two faces across the axis are missing", [](const SahCut& c) {
        const double face = c.size[(c.axis + 1) % 3] * c.size[(c.axis + 2) % 3], area = surface_of(c.size);
        return cost(c, {shares(c).below - face / area, shares(c).above - face / area});
    }));
    add(instead("edges", "sides are added up, where areas are asked for", [](const SahCut& c) {
        const double sum = c.size.x + c.size.y + c.size.z, side = c.size[c.axis];
        return cost(c, {(sum - side + c.place) / sum, (sum - c.place) / sum});
    }));
    add(instead("rest_of_area", "the upper half has the rest of the area, 1 minus the lower one's share",
                [](const SahCut& c) {
                    return cost(c, {shares(c).below, 1 - shares(c).below});
                }));
    add(instead("rest_of_area", "the halves' areas are divided by their sum, so that both chances make up 1",
                [](const SahCut& c) {
                    const auto [below, above] = shares(c);
                    return cost(c, {below / (below + above), above / (below + above)});
                }));
    return of_numbers(std::move(all), {"no_area"});
}

}  // namespace raylab::grading::cuts
