// Decides by products, and divides only where the plane is crossed.
#include "raylab/accelerator/split_tree/visited_halves.h"

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    const double way = plane - origin;
    if (direction == 0) {
        if (way > 0) return {{CellHalf::below, range}};
        if (way < 0) return {{CellHalf::above, range}};
        return {{CellHalf::below, range}, {CellHalf::above, range}};
    }
    const bool up = direction > 0;
    const double ahead = up ? way : -way, speed = up ? direction : -direction;
    const auto half = [&](bool before) { return before == up ? CellHalf::below : CellHalf::above; };
    if (ahead > range.max * speed) return {{half(true), range}};
    if (ahead < range.min * speed) return {{half(false), range}};
    const double t = ahead / speed;
    return {{half(true), {range.min, t}}, {half(false), {t, range.max}}};
}
