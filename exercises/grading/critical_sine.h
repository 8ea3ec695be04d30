#pragma once

#include "whole_numbers.h"

#include <cmath>

// Sines behind a surface, of rays that leave the denser side: below 1 they get out, above 1 all is reflected. Half of
// them are next to 1, where a threshold of somebody's own decides otherwise.

namespace raylab::grading {

/// How far the other half is off 1. Next to it means down to a ten-thousandth, in every order of size alike: a
/// direction or a share by any correct formula in double still has eleven digits there.
constexpr double off_one = 0.02, next_to_one = 1e-4;

inline double distance_next_to_one(Dice& dice) { return std::exp(dice.in(std::log(next_to_one), std::log(off_one))); }

inline double sine_of_what_gets_out(Dice& dice) {
    return 1 - (heads(dice) ? dice.in(off_one, 0.95) : distance_next_to_one(dice));
}

/// No more than this, which is more than 1.02.
inline double sine_of_what_is_kept(Dice& dice, double most) {
    return heads(dice) ? dice.in(1 + off_one, most) : 1 + distance_next_to_one(dice);
}

}  // namespace raylab::grading
