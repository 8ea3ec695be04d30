#pragma once

#include "raylab/geometry/ray.h"

#include <vector>

namespace raylab {

/// The two halves of a cell that a plane across an axis cuts; the plane belongs to both.
enum class CellHalf { below, above };

/// A half of a cell that a ray visits, and the range of t in which it is there.
struct VisitedHalf {
    CellHalf half;
    Interval<double> range;
};

/// The halves of a cell that a ray visits, in the order in which it comes to them. `origin` and `direction` are the
/// ray's coordinates along the axis that the plane stands across; in `range`, which is closed, the ray is in the cell.
/// (M. Kaplan: The Use of Spatial Coherence in Ray Tracing, 1985; F. Jansen: Data Structures for Ray Tracing, 1986.)
std::vector<VisitedHalf> visited_halves(double origin, double direction, double plane, const Interval<double>& range);

}  // namespace raylab
