// hint: t
// Compares the plane with how far the ray has gone, and forgets where it began.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0) {
        if (origin < plane) return {{CellHalf::below, range}};
        if (origin > plane) return {{CellHalf::above, range}};
        return {{CellHalf::below, range}, {CellHalf::above, range}};
    }
    const double first = range.min * direction, last = range.max * direction;
    if (first < plane && last < plane) return {{CellHalf::below, range}};
    if (first > plane && last > plane) return {{CellHalf::above, range}};
    const double t = plane / direction;
    const Interval<double> before{range.min, t}, after{t, range.max};
    if (first > last) return {{CellHalf::above, before}, {CellHalf::below, after}};
    return {{CellHalf::below, before}, {CellHalf::above, after}};
}
