// hint: parallel
// or: in_plane
// Lets infinity decide. Its sign is that of a zero: of a direction of +0, the wrong half on both sides of the plane.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const CellHalf near = direction > 0 ? CellHalf::below : CellHalf::above;
    const CellHalf far = direction > 0 ? CellHalf::above : CellHalf::below;
    const double t = (plane - origin) / direction;
    if (t > range.max) return {{near, range}};
    if (t < range.min) return {{far, range}};
    return {{near, {range.min, t}}, {far, {t, range.max}}};
}
