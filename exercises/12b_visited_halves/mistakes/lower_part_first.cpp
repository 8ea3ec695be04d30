// hint: order
// Finds out rightly which part of the range is below the plane and which above, and always gives the lower one first.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0) {
        if (origin == plane) return {{CellHalf::below, range}, {CellHalf::above, range}};
        return {{origin < plane ? CellHalf::below : CellHalf::above, range}};
    }
    const double t = (plane - origin) / direction;
    const bool up = direction > 0;
    if (t > range.max) return {{up ? CellHalf::below : CellHalf::above, range}};
    if (t < range.min) return {{up ? CellHalf::above : CellHalf::below, range}};
    Interval<double> lower{range.min, t}, upper{t, range.max};
    if (!up) {
        lower = {t, range.max};
        upper = {range.min, t};
    }
    return {{CellHalf::below, lower}, {CellHalf::above, upper}};
}
