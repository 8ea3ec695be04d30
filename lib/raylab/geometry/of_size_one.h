#pragma once

#include "raylab/geometry/vector.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace raylab {

inline double largest_coordinate(const Vec3d& v) {
    return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));  // not of a list: that would branch
}

/// The vector scaled so that its largest coordinate is one: its length may then be squared, which may overflow or vanish
/// before. Neither zero nor infinite (assertion).
inline Vec3d of_size_one(const Vec3d& v) {
    const double size = largest_coordinate(v);
    assert(size > 0 && std::isfinite(size));
    return v / size;
}

}  // namespace raylab
