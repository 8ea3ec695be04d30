// hint: whole_range
// Asks of each half whether it is visited at all, and not for which t.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <array>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const double t = direction == 0 ? 0 : (plane - origin) / direction;
    const auto is_visited = [&](CellHalf half) {
        const bool is_below = half == CellHalf::below;
        if (direction == 0) return is_below ? origin <= plane : origin >= plane;
        const bool comes_first = is_below == (direction > 0);
        return comes_first ? range.min <= t : t <= range.max;
    };
    std::array order{CellHalf::below, CellHalf::above};
    if (direction < 0) order = {CellHalf::above, CellHalf::below};
    std::vector<VisitedHalf> halves;
    for (const CellHalf half : order)
        if (is_visited(half)) halves.push_back({half, range});
    return halves;
}
