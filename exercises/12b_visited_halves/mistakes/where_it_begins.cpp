// hint: far_forgotten
// The half in which the ray is where its range begins.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0) {
        std::vector<VisitedHalf> halves;
        if (origin <= plane) halves.push_back({CellHalf::below, range});
        if (origin >= plane) halves.push_back({CellHalf::above, range});
        return halves;
    }
    const double first = origin + range.min * direction;
    return {{first < plane || (first == plane && direction > 0) ? CellHalf::below : CellHalf::above, range}};
}
