#pragma once

#include "raylab/geometry/vector.h"

#include <cstddef>

namespace raylab {

/// A cell that may be cut by a plane across an axis, and what would be in its two halves.
struct SahCut {
    Vec3d size;      // of the cell, along x, y and z
    std::size_t axis;  // 0, 1 or 2: which the plane stands across
    double place;    // 0 <= place <= size[axis]: how far from the cell's lower side
    double below, above;  // how many primitives would be on either side
    double visit_cost, test_cost;
    double empty_bonus;  // 0 <= empty_bonus < 1: the part of the tests' cost that a cut saves which leaves a side empty
};

/// The work that the surface area heuristic expects of a ray which meets the cell, if it is cut; infinite where the cell has
/// no area at all.
double sah_cost(const SahCut& cut);

}  // namespace raylab
