// hint: touch
// or: far_forgotten
// Goes on from where the range begins: if the plane is no way ahead of that, the nearer half is over.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <cmath>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0) {
        if (origin == plane) return {{CellHalf::above, range}, {CellHalf::below, range}};
        return {{origin < plane ? CellHalf::below : CellHalf::above, range}};
    }
    const CellHalf first = direction > 0 ? CellHalf::below : CellHalf::above;
    const CellHalf second = direction > 0 ? CellHalf::above : CellHalf::below;
    const double begin = origin + range.min * direction;
    const double ahead = direction > 0 ? plane - begin : begin - plane;
    if (ahead <= 0) return {{second, range}};
    const double t = range.min + ahead / std::abs(direction);
    if (t > range.max) return {{first, range}};
    return {{first, {range.min, t}}, {second, {t, range.max}}};
}
