#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/double_double.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab {

/// The way from a point of a shape that has only translated, where it stands at the ray's time, to the ray's origin:
/// origin - (point + placement.translation + time motion.translation). What the filters ask of a difference of floats
/// holds for it: each coordinate errs by less than (1 + 2^-10) roundings of its own, and is zero or lies between 2^-149
/// and 2^130. Absent: it does not, as where nearly all of a coordinate cancels.
//
// The product of time and speed is one of two floats, exact. Each sum keeps what rounding cuts off, so that all of it
// is added at the end: three numbers below u times the largest on the way, whose sums err by less than 6 u^2 of it, or
// not at all where only the last of them is not zero. Absent is what errs by more or is larger or smaller.
inline std::optional<Vec3d> origin_from_moved(const Ray& ray, const Vec3f& point, const Affine& placement,
                                              const Motion& motion) {
    constexpr double room = 0x1p-10 / (8 * unit_roundoff<double>);
    Vec3d way;
    for (int i = 0; i < 3; ++i) {
        const DoubleDouble seen = two_sum(ray.origin[i], -double{point[i]});
        const DoubleDouble placed = two_sum(seen.high, -double{placement.translation[i]});
        const DoubleDouble moved = two_sum(placed.high, -(double{ray.time} * double{motion.translation[i]}));
        way[i] = moved.high + (moved.low + (placed.low + seen.low));
        const double size = std::abs(way[i]), on_the_way = std::max(std::abs(seen.high), std::abs(placed.high));
        if ((placed.low != 0 || seen.low != 0) && !(on_the_way <= room * size)) return std::nullopt;
        if (size != 0 && !(size >= 0x1p-149 && size < 0x1p130)) return std::nullopt;
    }
    return way;
}

}  // namespace raylab
