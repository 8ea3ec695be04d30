// hint: less_than_epsilon
// or: small_is_not_zero
// Asks whether the direction is less than an epsilon, and not whether its size is.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <utility>
#include <vector>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    std::vector<VisitedHalf> visited;
    if (direction < 1e-15) {
        if (origin <= plane) visited.push_back({CellHalf::below, range});
        if (plane <= origin) visited.push_back({CellHalf::above, range});
        return visited;
    }
    const double t = (plane - origin) / direction;
    if (t >= range.min) visited.push_back({CellHalf::below, {range.min, t < range.max ? t : range.max}});
    if (t <= range.max) visited.push_back({CellHalf::above, {t > range.min ? t : range.min, range.max}});
    return visited;
}
