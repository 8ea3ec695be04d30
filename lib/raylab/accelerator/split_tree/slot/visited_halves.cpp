#include "raylab/accelerator/split_tree/visited_halves.h"

#include <utility>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    using enum CellHalf;
    if (direction == 0) {  // parallel to the plane: t would be infinite, or 0 / 0
        std::vector<VisitedHalf> halves;
        if (origin <= plane) halves.push_back({below, range});
        if (origin >= plane) halves.push_back({above, range});
        return halves;
    }
    const auto [nearer, farther] = direction > 0 ? std::pair(below, above) : std::pair(above, below);
    const double t = (plane - origin) / direction;
    if (t > range.max) return {{nearer, range}};
    if (t < range.min) return {{farther, range}};
    return {{nearer, {range.min, t}}, {farther, {t, range.max}}};
}
