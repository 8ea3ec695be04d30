// hint: touch
// or: far_forgotten
// The farther half counts only where something of the range is left for it.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    std::vector<VisitedHalf> halves;
    if (direction == 0) {
        for (const CellHalf half : {CellHalf::below, CellHalf::above})
            if (half == CellHalf::below ? origin <= plane : origin >= plane) halves.push_back({half, range});
        return halves;
    }
    const double t = (plane - origin) / direction;
    const double begin = std::max(t, range.min);
    const bool up = direction > 0;
    if (t >= range.min) halves.push_back({up ? CellHalf::below : CellHalf::above, {range.min, std::min(t, range.max)}});
    if (range.max - begin > 0) halves.push_back({up ? CellHalf::above : CellHalf::below, {begin, range.max}});
    return halves;
}
