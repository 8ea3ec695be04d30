// hint: far_forgotten
// The half in which the middle of the range lies.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0) {
        std::vector<VisitedHalf> halves;
        if (origin <= plane) halves.push_back({CellHalf::below, range});
        if (origin >= plane) halves.push_back({CellHalf::above, range});
        return halves;
    }
    const double last = range.max > 1e300 ? range.min + 1 : range.max;
    const double middle = origin + 0.5 * (range.min + last) * direction;
    return {{middle <= plane ? CellHalf::below : CellHalf::above, range}};
}
