#pragma once

#include "truth.h"
#include "whole_numbers.h"

#include <algorithm>
#include <initializer_list>

// The cases. What a branch can bring is at least 0.2 % off the least, except in powers of two.

namespace raylab::grading::branches {

/// A surface in a scene, with a least that is not set yet.
inline Arguments any_hit(Dice& dice, double rho, int levels) {
    const double weight = std::exp(dice.in(-4, -0.1)), share = dice.in(0.4, 0.9) * rho, part = dice.in(0.15, 0.85);
    return {weight, part * share, (1 - part) * share, levels, std::exp(dice.in(-2, 3)), rho, 0};
}

inline bool is_clear(const Arguments& given) {
    return std::ranges::all_of(std::initializer_list<double>{given.reflected, given.transmitted}, [&](double share) {
        return std::abs(most(given, share) - given.least) > 0.002 * given.least;
    });
}

/// The least is this share of what one of the branches can bring, or a little more or less.
inline Arguments with_least(Dice& dice, const Arguments& given, double low, double high) {
    for (;;) {
        Arguments asked = given;
        const double share = heads(dice) ? given.reflected : given.transmitted;
        asked.least = most(given, share) * std::exp(dice.in(std::log(low), std::log(high)));
        if (is_clear(asked)) return asked;
    }
}

inline Arguments many_levels(Dice& dice) {
    return with_least(dice, any_hit(dice, dice.in(0.3, 0.9), whole(dice, 60, 200)), 0.2, 3);
}

/// A branch could bring more than the least if it went on for ever, and does not in the levels that are left.
inline Arguments few_levels(Dice& dice) {
    const double rho = dice.in(0.5, 0.97);
    const int levels = whole(dice, 2, 5);
    return with_least(dice, any_hit(dice, rho, levels), 1.02, 1 / (1 - std::pow(rho, levels)));
}

/// A branch brings more than the least by what all its levels bring together, and by none of them alone.
inline Arguments all_levels_count(Dice& dice) {
    const double rho = dice.in(0.7, 0.97);
    const int levels = whole(dice, 4, 12);
    return with_least(dice, any_hit(dice, rho, levels), 1 / series(rho, levels), 0.97);
}

inline Arguments last_but_one(Dice& dice) { return with_least(dice, any_hit(dice, dice.in(0.4, 0.95), 1), 0.4, 2); }

inline Arguments no_level_left(Dice& dice) {
    Arguments given = any_hit(dice, dice.in(0.4, 1), 1);
    given.least = most(given, given.reflected) * dice.in(0.01, 0.5);
    given.levels = 0;
    return given;
}

/// One branch is followed at least, since a sum that is no number follows none; with many levels by a little only,
/// which a rho that is nearly 1 does not bring.
inline Arguments all_is_mirrored(Dice& dice) {
    const bool are_many = heads(dice);
    for (;;) {
        Arguments asked = any_hit(dice, 1, are_many ? whole(dice, 200, 400) : whole(dice, 2, 40));
        const double stronger = most(asked, std::max(asked.reflected, asked.transmitted));
        asked.least = stronger * (are_many ? dice.in(0.993, 0.996) : dice.in(0.3, 0.95));
        if (is_clear(asked)) return asked;
    }
}

inline Arguments nearly_all(Dice& dice) {
    return with_least(dice, any_hit(dice, 1 - std::exp(dice.in(-14, -7)), whole(dice, 2, 40)), 0.3, 2);
}

/// A rho a little below 1, and so many levels that they do not bring as much as if it were 1.
inline Arguments a_little_below_one(Dice& dice) {
    const double lost = std::exp(dice.in(std::log(1e-4), std::log(9e-3)));
    const int levels = static_cast<int>(std::min(2000.0, dice.in(0.8, 2) / lost));
    const double too_much = levels / series(1 - lost, levels);
    return with_least(dice, any_hit(dice, 1 - lost, levels), 1.005, 0.995 * too_much);
}

/// A scene so dim that each of its numbers is less than any epsilon; what may be lost is less as well.
inline Arguments dim(Dice& dice) {
    const int levels = whole(dice, 1, 20);
    for (;;) {
        Arguments asked = any_hit(dice, dice.in(0.4, 0.95), levels);
        asked.brightest = std::exp(dice.in(-30, -10));
        asked.least = most(asked, std::max(asked.reflected, asked.transmitted)) * dice.in(0.2, 0.97);
        if (is_clear(asked)) return asked;
    }
}

/// A ray that has lost nearly all of its weight, in a scene so bright that it is worth following.
inline Arguments faint(Dice& dice) {
    const int levels = whole(dice, 1, 20);
    for (;;) {
        Arguments asked = any_hit(dice, dice.in(0.4, 0.95), levels);
        asked.weight = std::exp(dice.in(-25, -12));
        asked.brightest = std::exp(dice.in(8, 12));
        asked.least = most(asked, std::max(asked.reflected, asked.transmitted)) * dice.in(0.2, 0.97);
        if (is_clear(asked)) return asked;
    }
}

/// The stronger branch is followed, the weaker one is not.
inline Arguments one_of_two(Dice& dice) {
    for (;;) {
        Arguments given = any_hit(dice, dice.in(0.4, 0.95), whole(dice, 1, 20));
        const double a = most(given, given.reflected), b = most(given, given.transmitted);
        if (std::max(a, b) < 1.5 * std::min(a, b)) continue;
        given.least = std::sqrt(a * b);
        return given;
    }
}

/// Neither branch is worth it; both together would not be, and one that had all of the arriving ray's weight would.
inline Arguments not_even_both(Dice& dice) {
    Arguments given = any_hit(dice, dice.in(0.4, 0.9), whole(dice, 1, 20));
    given.least = std::lerp(most(given, given.reflected + given.transmitted), most(given, 1), dice.in(0.1, 0.9));
    return given;
}

/// Neither branch is worth it, and both together would be.
inline Arguments both_together(Dice& dice) {
    Arguments given = any_hit(dice, dice.in(0.4, 0.9), whole(dice, 1, 20));
    given.least = std::lerp(most(given, std::max(given.reflected, given.transmitted)),
                            most(given, given.reflected + given.transmitted), dice.in(0.1, 0.9));
    return given;
}

/// The arriving ray hardly lost any weight, and not even all of it would be worth it.
inline Arguments not_even_the_ray(Dice& dice) {
    Arguments given = any_hit(dice, dice.in(0.4, 0.9), whole(dice, 1, 20));
    given.weight = dice.in(0.9, 1);
    given.least = most(given, 1) * dice.in(1.05, 1.5);
    return given;
}

/// What one branch can bring is the least itself: in powers of two, and their sums.
inline Arguments exactly_the_least(Dice& dice) {
    const double rho = heads(dice) ? 1 : 0.5;
    const double other = rho == 1 ? 0.5 : power_of_two(dice, -5, -3);
    Arguments given{power_of_two(dice, -6, 0), 0.25, other, whole(dice, 1, 8), power_of_two(dice, -2, 4), rho, 0};
    if (heads(dice)) std::swap(given.reflected, given.transmitted);
    given.least = most(given, 0.25);
    return given;
}

/// One of the two rays does not exist, and nothing at all may be lost.
inline Arguments opaque_or_black(Dice& dice) {
    Arguments given = any_hit(dice, dice.in(0.4, 0.95), whole(dice, 1, 6));
    (heads(dice) ? given.reflected : given.transmitted) = 0;
    return given;
}

inline Arguments up_to_rounding(Dice& dice) {
    Arguments given = any_hit(dice, dice.in(0.4, 0.95), whole(dice, 2, 20));
    given.least = most(given, given.reflected) * (1 + dice.in(-2e-16, 2e-16));
    return given;
}

}  // namespace raylab::grading::branches
