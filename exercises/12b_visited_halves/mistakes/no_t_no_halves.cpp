// hint: parallel
// or: nothing_visited
// Where t is no finite number there is no crossing, and nothing is visited.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>
#include <cmath>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const double t = (plane - origin) / direction;
    std::vector<VisitedHalf> halves;
    if (!std::isfinite(t)) return halves;
    const Interval<double> before{range.min, std::min(range.max, t)}, after{std::max(range.min, t), range.max};
    const bool up = direction > 0;
    if (before.min <= before.max) halves.push_back({up ? CellHalf::below : CellHalf::above, before});
    if (after.min <= after.max) halves.push_back({up ? CellHalf::above : CellHalf::below, after});
    return halves;
}
