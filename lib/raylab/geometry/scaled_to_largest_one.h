#pragma once

#include "raylab/geometry/largest_coordinate.h"

#include <cassert>
#include <cmath>

namespace raylab {

/// The vector scaled so that its largest coordinate is one: its length may then be squared, which may overflow or
/// vanish before. Neither zero nor infinite (assertion).
inline Vec3d scaled_to_largest_one(const Vec3d& v) {
    const double size = largest_coordinate(v);
    assert(size > 0 && std::isfinite(size));
    return v / size;
}

}  // namespace raylab
