// hint: in_plane
// or: parallel
// Compares products; a parallel ray is above the plane or else below it, and one in the plane is below, too.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const double way = plane - origin;
    if (direction == 0) return {{way < 0 ? CellHalf::above : CellHalf::below, range}};
    const bool up = direction > 0;
    const double ahead = up ? way : -way, speed = up ? direction : -direction;
    const auto half = [&](bool before) { return before == up ? CellHalf::below : CellHalf::above; };
    if (ahead > range.max * speed) return {{half(true), range}};
    if (ahead < range.min * speed) return {{half(false), range}};
    const double t = ahead / speed;
    return {{half(true), {range.min, t}}, {half(false), {t, range.max}}};
}
