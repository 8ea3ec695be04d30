// hint: always_both
// Mirrors rays that go down, and cuts the range at t without asking whether t is in it.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <utility>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    if (direction == 0) {
        if (origin < plane) return {{CellHalf::below, range}};
        if (origin > plane) return {{CellHalf::above, range}};
        return {{CellHalf::below, range}, {CellHalf::above, range}};
    }
    CellHalf before = CellHalf::below, after = CellHalf::above;
    if (direction < 0) {
        std::swap(before, after);
        direction = -direction;
        origin = -origin;
        plane = -plane;
    }
    const double t = (plane - origin) / direction;
    const VisitedHalf first{before, {range.min, t}}, second{after, {t, range.max}};
    return {first, second};
}
