// hint: far_forgotten
// The half in which the ray is where its range begins, as far as the plane, and nothing after it.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0 && origin == plane) return {{CellHalf::below, range}, {CellHalf::above, range}};
    if (direction == 0) return {{origin < plane ? CellHalf::below : CellHalf::above, range}};
    const double first = origin + range.min * direction;
    const bool is_below = direction > 0 ? first <= plane : first < plane;
    double end = range.max;
    if (const double t = (plane - origin) / direction; t >= range.min && t < range.max) end = t;
    return {{is_below ? CellHalf::below : CellHalf::above, {range.min, end}}};
}
