// hint: one_t
// The far part begins a millionth of the range later.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const double way = plane - origin;
    if (direction == 0 && way == 0) return {{CellHalf::below, range}, {CellHalf::above, range}};
    const bool from_below = direction == 0 ? way > 0 : direction > 0;
    const CellHalf first = from_below ? CellHalf::below : CellHalf::above;
    const CellHalf second = from_below ? CellHalf::above : CellHalf::below;
    if (direction == 0 || way / direction > range.max) return {{first, range}};
    const double t = way / direction;
    if (t < range.min) return {{second, range}};
    return {{first, {range.min, t}}, {second, {t + 1e-6 * (t - range.min), range.max}}};
}
