// hint: before_start
// or: far_forgotten
// Compares ways along the axis, and takes a plane behind the origin for one that the ray has left behind.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <cmath>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const double sign = direction < 0 ? -1 : 1, speed = std::abs(direction), ahead = sign * (plane - origin);
    const auto from = sign > 0 ? CellHalf::below : CellHalf::above, to = sign > 0 ? CellHalf::above : CellHalf::below;
    if (speed == 0) {
        if (ahead == 0) return {{from, range}, {to, range}};
        return {{origin < plane ? CellHalf::below : CellHalf::above, range}};
    }
    const bool is_behind = ahead < 0, is_before_range = ahead < range.min * speed;
    if (is_behind || is_before_range) return {{to, range}};
    if (ahead > range.max * speed) return {{from, range}};
    return {{from, {range.min, ahead / speed}}, {to, {ahead / speed, range.max}}};
}
