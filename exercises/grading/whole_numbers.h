#pragma once

#include "dice.h"

// Numbers that no correct formula in doubles rounds: whole ones, and powers of two. A case on a boundary (a tangent, an
// edge, the end of a range) counts only where it is made of them.

namespace raylab::grading {

inline int whole(Dice& dice, int low, int high) { return low + static_cast<int>(dice.in(0, high - low + 1)); }

inline bool heads(Dice& dice) { return dice.in(0, 1) < 0.5; }

inline double sign(Dice& dice) { return heads(dice) ? 1 : -1; }

inline double power_of_two(Dice& dice, int low, int high) { return std::ldexp(1.0, whole(dice, low, high)); }

inline Vec3d whole_point(Dice& dice, int low, int high) {
    const int x = whole(dice, low, high), y = whole(dice, low, high);
    return {x, y, whole(dice, low, high)};
}

/// Along one of the axes, forward or backward, of this length.
inline Vec3d along(int axis, double length) {
    Vec3d v{0, 0, 0};
    v[axis % 3] = length;
    return v;
}

}  // namespace raylab::grading
