#pragma once

#include "raylab/geometry/vector.h"

#include <array>

// Two unit squares, about which most is known.

namespace raylab::cornell {

using Quadrilateral = std::array<Vec3d, 4>;

/// The unit square in the plane z = 0, seen from above.
Quadrilateral lower_square();

/// A square of this side that faces the lower one, its middle above the other's.
Quadrilateral upper_square(double height, double side = 1);

/// A unit square that stands on the edge y = 0 of the lower one and leans towards it by this angle, in radians, between
/// the two.
Quadrilateral leaning_square(double angle);

}  // namespace raylab::cornell
