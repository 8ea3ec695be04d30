// A ray that goes down is one that goes up in a mirror.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction < 0) {
        auto halves = visited_halves(-origin, -direction, -plane, range);
        for (VisitedHalf& visited : halves)
            visited.half = visited.half == CellHalf::below ? CellHalf::above : CellHalf::below;
        return halves;
    }
    std::vector<VisitedHalf> halves;
    const double t = direction > 0 ? (plane - origin) / direction : 0;
    if (direction == 0 ? origin <= plane : range.min <= t)
        halves.push_back({CellHalf::below, {range.min, direction == 0 ? range.max : std::min(t, range.max)}});
    if (direction == 0 ? origin >= plane : t <= range.max)
        halves.push_back({CellHalf::above, {direction == 0 ? range.min : std::max(t, range.min), range.max}});
    return halves;
}
