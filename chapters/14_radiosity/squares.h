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

/// Two squares whose form factor is known from elsewhere: Howell's closed forms, evaluated with thirty digits. No
/// method of the lab is the judge of another, or of itself.
struct KnownPair {
    Quadrilateral from, to;
    double form_factor;
};
KnownPair facing_5_apart();
KnownPair facing_1_apart();
KnownPair facing_half_apart();
KnownPair facing_tenth_apart();
KnownPair sharing_an_edge();  // at a right angle

}  // namespace raylab::cornell
