// hint: order
// or: which_side
// Takes the lower half for the nearer one, whichever way the ray goes.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0) {
        std::vector<VisitedHalf> halves;
        if (origin <= plane) halves.push_back({CellHalf::below, range});
        if (origin >= plane) halves.push_back({CellHalf::above, range});
        return halves;
    }
    const double t = (plane - origin) / direction;
    const CellHalf near = CellHalf::below;
    const CellHalf far = CellHalf::above;
    if (t > range.max) return {{near, range}};
    if (t < range.min) return {{far, range}};
    return {{near, {range.min, t}}, {far, {t, range.max}}};
}
