#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A cell that may be cut by a plane across an axis, and what would be in its two halves.
struct SahCut {
    Vec3d size;           // of the cell, along x, y and z
    int axis;             // 0, 1 or 2: which the plane stands across
    double place;         // 0 <= place <= size[axis]: how far from the cell's lower side
    double below, above;  // how many things would be on either side
    double visit_cost, test_cost;
    double empty_bonus;  // 0 <= empty_bonus < 1: the share of the tests' cost that is saved where a side is empty
};

/// The work that the surface area heuristic expects of a ray which meets the cell, if it is cut; infinite where the
/// cell has no area at all. This is the slot of exercise 12.
double sah_cost(const SahCut& cut);

}  // namespace raylab
