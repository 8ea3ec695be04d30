// hint: less_than_epsilon
// or: small_is_not_zero
// Knows which half comes first when a ray goes down, but never gets there: its direction is less than any epsilon.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    constexpr double epsilon = 1e-12;
    if (direction < epsilon) {
        if (origin < plane) return {{CellHalf::below, range}};
        if (origin > plane) return {{CellHalf::above, range}};
        return {{CellHalf::below, range}, {CellHalf::above, range}};
    }
    const CellHalf near = direction > 0 ? CellHalf::below : CellHalf::above;
    const CellHalf far = direction > 0 ? CellHalf::above : CellHalf::below;
    const double at_plane = (plane - origin) / direction;
    if (at_plane > range.max) return {{near, range}};
    if (at_plane < range.min) return {{far, range}};
    return {{near, {range.min, at_plane}}, {far, {at_plane, range.max}}};
}
