// hint: one_t
// A thousandth of overlap, to be safe.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    std::vector<VisitedHalf> halves;
    if (direction == 0) {
        if (origin <= plane) halves.push_back({CellHalf::below, range});
        if (origin >= plane) halves.push_back({CellHalf::above, range});
        return halves;
    }
    const CellHalf near = direction > 0 ? CellHalf::below : CellHalf::above;
    const CellHalf far = direction > 0 ? CellHalf::above : CellHalf::below;
    const double t = (plane - origin) / direction;
    if (t > range.max) return {{near, range}};
    if (t < range.min) return {{far, range}};
    return {{near, {range.min, t + 1e-3}}, {far, {t - 1e-3, range.max}}};
}
