#pragma once

#include <cmath>
#include <limits>

namespace raylab {

/// The float nearest to x among those not below it, if `toward` is positive, or not above it, if it is negative; the
/// nearest one of all if it is zero.
inline float rounded_toward(double x, double toward) {
    const float nearest = static_cast<float>(x);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (toward > 0 && nearest < x) return std::nextafter(nearest, infinity);
    if (toward < 0 && nearest > x) return std::nextafter(nearest, -infinity);
    return nearest;
}

}  // namespace raylab
