// hint: order
// or: which_side
// The lower half gets what is before t and the upper one what is after it, though a ray that goes down comes from
// above.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    std::vector<VisitedHalf> halves;
    if (direction == 0) {
        if (plane >= origin) halves.push_back({CellHalf::below, range});
        if (plane <= origin) halves.push_back({CellHalf::above, range});
        return halves;
    }
    const double t = (plane - origin) / direction;
    if (range.min <= t) halves.push_back({CellHalf::below, {range.min, std::min(t, range.max)}});
    if (t <= range.max) halves.push_back({CellHalf::above, {std::max(t, range.min), range.max}});
    return halves;
}
