// hint: before_start
// or: whole_range
// Begins at 0 at the earliest.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>
#include <limits>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool flat = direction == 0, up = direction > 0;
    const double t = flat ? 0 : (plane - origin) / direction;
    std::vector<VisitedHalf> halves;
    const auto visit = [&](CellHalf half, double from, double to) {
        const double low = std::max({0.0, range.min, from}), high = std::min(range.max, to);
        if (low <= high) halves.push_back({half, {low, high}});
    };
    if (!flat || origin <= plane) visit(CellHalf::below, flat || up ? -infinity : t, flat || !up ? infinity : t);
    if (!flat || origin >= plane) visit(CellHalf::above, flat || !up ? -infinity : t, flat || up ? infinity : t);
    if (direction < 0) std::ranges::reverse(halves);
    return halves;
}
