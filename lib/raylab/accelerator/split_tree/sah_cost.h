#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A cell that may be split by a plane across an axis, and the numbers of primitives in its two halves.
struct SahCut {
    Vec3d size;           // of the cell, along x, y and z
    int axis;             // 0, 1 or 2: the axis to which the plane is perpendicular
    double place;         // 0 <= place <= size[axis]: the plane's distance from the cell's lower side
    double below, above;  // how many primitives would be on either side
    double visit_cost, test_cost;
    double empty_bonus;  // 0 <= empty_bonus < 1: the share of the tests' cost that is saved where a side is empty
};

/// The cost that the surface area heuristic expects for a ray that hits the cell, if the cell is split; infinite where
/// the cell has no area at all. This is the slot of exercise 12.
double sah_cost(const SahCut& cut);

}  // namespace raylab
