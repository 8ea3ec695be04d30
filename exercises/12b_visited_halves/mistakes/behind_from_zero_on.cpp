// hint: before_start
// or: far_forgotten, touch
// Leaves out the half beyond the plane wherever t is not positive, and takes the origin's half for the first.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <utility>
#include <vector>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const bool rises = direction > 0;
    CellHalf here = CellHalf::above, beyond = CellHalf::below;
    if (origin < plane || (origin == plane && !rises)) std::swap(here, beyond);
    if (direction == 0) {
        if (origin == plane) return {{here, range}, {beyond, range}};
        return {{here, range}};
    }
    const double t = (plane - origin) / direction;
    if (t <= 0 || t > range.max) return {{here, range}};
    if (t < range.min) return {{beyond, range}};
    return {{here, {range.min, t}}, {beyond, {t, range.max}}};
}
