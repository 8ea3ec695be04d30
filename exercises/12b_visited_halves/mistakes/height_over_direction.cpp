// hint: t
// Takes the height of the origin over the plane, asks it rightly for its side, and divides it as it is.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const double height = origin - plane;
    std::vector<VisitedHalf> halves;
    if (direction == 0) {
        if (height <= 0) halves.push_back({CellHalf::below, range});
        if (height >= 0) halves.push_back({CellHalf::above, range});
        return halves;
    }
    const double t = height / direction;
    const bool up = direction > 0;
    if (range.min <= t) halves.push_back({up ? CellHalf::below : CellHalf::above, {range.min, std::min(t, range.max)}});
    if (t <= range.max) halves.push_back({up ? CellHalf::above : CellHalf::below, {std::max(t, range.min), range.max}});
    return halves;
}
