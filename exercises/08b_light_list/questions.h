#pragma once

#include "truth.h"
#include "whole_numbers.h"

#include <cmath>

// The cases: sorted lists, and what the way to the light meets in them.

namespace raylab::grading::light_list {

inline constexpr double none_fills = std::numeric_limits<double>::infinity();

inline double glass(Dice& dice) { return dice.in(0.2, 0.9); }

/// A list of this many entries that the way misses, and a point beyond them all.
inline Arguments any_list(Dice& dice, int entries) {
    Arguments given{0, none_fills, {}};
    double depth = dice.in(0.1, 1);
    for (int i = 0; i < entries; ++i) {
        given.entries.push_back({depth, 1});
        depth += dice.in(0.1, 1);
    }
    given.depth = depth;
    return given;
}

inline double& through(Arguments& given, int i) { return given.entries[static_cast<std::size_t>(i)].through; }

inline Arguments nothing_in_the_way(Dice& dice) { return any_list(dice, whole(dice, 1, 6)); }

inline Arguments something_opaque(Dice& dice) {
    const int entries = whole(dice, 3, 8);
    Arguments given = any_list(dice, entries);
    through(given, whole(dice, 0, entries - 2)) = 0;
    return given;
}

/// Two panes of glass or three, and what is missed between them.
inline Arguments panes(Dice& dice) {
    const int entries = whole(dice, 4, 8);
    Arguments given = any_list(dice, entries);
    for (int panes = whole(dice, 2, 3); panes > 0;) {
        double& share = through(given, whole(dice, 0, entries - 1));
        if (share == 1) share = glass(dice), --panes;
    }
    return given;
}

inline Arguments glass_then_opaque(Dice& dice) {
    const int entries = whole(dice, 4, 8), opaque = whole(dice, 1, entries - 2);
    Arguments given = any_list(dice, entries);
    through(given, opaque) = 0;
    through(given, whole(dice, 0, opaque - 1)) = glass(dice);
    if (heads(dice)) through(given, opaque + 1) = 0;
    return given;
}

/// The point is nearer to the light than the last two entries at least; what is beyond it is not in its way.
inline Arguments list_goes_on(Dice& dice) {
    const int entries = whole(dice, 4, 8), before = whole(dice, 0, entries - 2);
    Arguments given = any_list(dice, entries);
    const double first_beyond = given.entries[static_cast<std::size_t>(before)].begin;
    given.depth = before == 0 ? first_beyond * dice.in(0.2, 0.9)
                              : std::lerp(given.entries[static_cast<std::size_t>(before - 1)].begin, first_beyond,
                                          dice.in(0.1, 0.9));
    if (before > 0) through(given, before - 1) = glass(dice);
    if (before > 1 && heads(dice)) through(given, before - 2) = glass(dice);
    return given;
}

/// What fills the cell is the last entry; the point lies behind it.
inline Arguments behind_what_fills(Dice& dice) {
    const int entries = whole(dice, 2, 6);
    Arguments given = any_list(dice, entries);
    given.filled = given.entries.back().begin + dice.in(0, 0.5);
    given.depth = given.filled + dice.in(0.1, 3);
    through(given, entries - 1) = 0;
    if (heads(dice)) through(given, 0) = heads(dice) ? 0 : glass(dice);
    return given;
}

/// The point lies before what fills the cell, or on it.
inline Arguments before_what_fills(Dice& dice) {
    const int entries = whole(dice, 3, 6);
    Arguments given = any_list(dice, entries);
    given.depth = given.entries.back().begin - dice.in(0.01, 0.09);
    given.filled = given.entries.back().begin + dice.in(0, 0.5);
    through(given, whole(dice, 0, entries - 2)) = glass(dice);
    return given;
}

/// The point is as deep as what fills the cell: it lies on it, and the light side of it.
inline Arguments on_what_fills(Dice& dice) {
    Arguments given = any_list(dice, whole(dice, 2, 6));
    given.depth = given.filled = given.entries.back().begin;
    through(given, 0) = glass(dice);
    return given;
}

/// Something in the way begins exactly as deep as the point.
inline Arguments as_deep_as_an_entry(Dice& dice) {
    const int entries = whole(dice, 3, 7), at = whole(dice, 1, entries - 1);
    Arguments given = any_list(dice, entries);
    given.depth = given.entries[static_cast<std::size_t>(at)].begin;
    through(given, at) = heads(dice) ? 0 : glass(dice);
    if (heads(dice)) through(given, at - 1) = glass(dice);
    return given;
}

inline Arguments empty_list(Dice& dice) { return {dice.in(0.5, 5), none_fills, {}}; }

/// What fills the cell stands in no list: nothing is tested, and it is dark.
inline Arguments empty_and_filled(Dice& dice) {
    const double filled = dice.in(0.3, 3);
    return {filled + dice.in(0.1, 2), filled, {}};
}

/// Behind five or six dark panes there is still some light, and behind one as dark as a welder's, too.
inline Arguments hardly_any_light(Dice& dice) {
    const int entries = whole(dice, 5, 6);
    Arguments given = any_list(dice, entries);
    if (heads(dice))
        through(given, whole(dice, 0, entries - 1)) = std::pow(10, -dice.in(2, 8));
    else
        for (Entry& entry : given.entries) entry.through = dice.in(0.15, 0.3);
    return given;
}

/// The next entry begins hardly deeper than the point, which is not as deep yet.
inline Arguments hardly_before_an_entry(Dice& dice) {
    Arguments given = list_goes_on(dice);
    given.depth = given.entries[static_cast<std::size_t>(reached(given))].begin * (1 - std::pow(10, -dice.in(4, 12)));
    return given;
}

/// The point lies hardly behind what fills the cell, and that is behind it.
inline Arguments hardly_behind_what_fills(Dice& dice) {
    Arguments given = behind_what_fills(dice);
    given.depth = given.filled * (1 + std::pow(10, -dice.in(4, 12)));
    return given;
}

/// All entries begin at the same depth.
inline Arguments equally_deep(Dice& dice) {
    Arguments given = panes(dice);
    for (Entry& entry : given.entries) entry.begin = given.entries[0].begin;
    if (heads(dice)) given.depth = given.entries[0].begin;
    return given;
}

}  // namespace raylab::grading::light_list
