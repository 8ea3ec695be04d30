#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/vector.h"

#include <algorithm>
#include <cmath>

// The largest coordinate, signs aside: the size that rounding errors are proportional to.

namespace raylab {

inline double largest_coordinate(const Vec3d& v) {
    return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));  // not of a list: that would branch
}

inline double largest_coordinate(const Box& box) {
    return std::max(largest_coordinate(convert<double>(box.min)), largest_coordinate(convert<double>(box.max)));
}

}  // namespace raylab
