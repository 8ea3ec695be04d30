// Where the ray is at the ends of its range says which halves it visits.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <limits>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto place = [&](double t) { return direction == 0 ? origin : origin + t * direction; };
    const double first = place(range.min), last = place(range.max);
    if (first < plane && last < plane) return {{CellHalf::below, range}};
    if (first > plane && last > plane) return {{CellHalf::above, range}};
    const double t = direction == 0 ? infinity : (plane - origin) / direction;
    if (t == infinity) return {{CellHalf::above, range}, {CellHalf::below, range}};
    const VisitedHalf before{first < last ? CellHalf::below : CellHalf::above, {range.min, t}};
    const VisitedHalf after{first < last ? CellHalf::above : CellHalf::below, {t, range.max}};
    return {before, after};
}
