// Both halves, each with its part, in the order of their beginnings.
#include "raylab/accelerator/split_tree/visited_halves.h"

#include <algorithm>
#include <utility>

std::vector<raylab::VisitedHalf> raylab::visited_halves(double origin, double direction, double plane,
                                                        const Interval<double>& range) {
    std::vector<std::pair<std::pair<double, double>, CellHalf>> parts;
    const double t = direction == 0 ? 0 : (plane - origin) / direction;
    for (const CellHalf half : {CellHalf::below, CellHalf::above}) {
        const double outward = half == CellHalf::below ? 1 : -1;
        double from = range.min, to = range.max;
        if (direction * outward > 0) to = std::min(to, t);
        if (direction * outward < 0) from = std::max(from, t);
        const bool beside = direction == 0 && (origin - plane) * outward > 0;
        if (from <= to && !beside) parts.push_back({{from, to}, half});
    }
    std::sort(parts.begin(), parts.end());
    std::vector<VisitedHalf> halves;
    for (const auto& [span, half] : parts) halves.push_back({half, {span.first, span.second}});
    return halves;
}
