#pragma once

#include "raylab/geometry/intersect/intersect.h"
#include "raylab/number/enclosure.h"
#include "raylab/number/root.h"

#include <cmath>
#include <limits>
#include <optional>

namespace raylab {

/// A t this well known, rounded to float, is within one unit in the last place of the exact one: a unit is at least
/// 2^-24 |t|, rounding costs half of it, and this a quarter.
inline constexpr double t_accuracy = 0x1p-26;

inline bool is_accurate(double t, double t_error) { return t_error <= t_accuracy * std::abs(t); }

/// True if t lies in the closed range. Infinite ends are no bounds.
template <Scalar T>
bool is_within(const Root<T>& t, const Interval<float>& range, Signs<T>& signs) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (range.min == infinity || range.max == -infinity) return false;
    if (range.min != -infinity && compare(t, T(range.min), signs) == Sign::negative) return false;
    return range.max == infinity || compare(t, T(range.max), signs) != Sign::positive;
}

/// True if a ray that goes against (negative) or along (positive) the normal sees a shape with these sides. A tangent
/// ray sees both.
inline bool sees(Sides sides, Sign along_normal) {
    if (sides == Sides::both) return true;
    return along_normal != (sides == Sides::front ? Sign::positive : Sign::negative);
}

}  // namespace raylab
