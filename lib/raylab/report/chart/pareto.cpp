#include "raylab/report/chart/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace raylab {

std::vector<std::size_t> pareto_front(std::span<const Tradeoff> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isnan(points[i].error) && !std::isnan(points[i].time)) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::tuple(points[i].error, points[i].time); });

    std::vector<std::size_t> front;
    for (const auto i : order) {
        const bool beats_last = front.empty() || points[i].time < points[front.back()].time;
        const bool equals_last = !front.empty() && points[i].time == points[front.back()].time &&
                                 points[i].error == points[front.back()].error;
        if (beats_last || equals_last) front.push_back(i);
    }
    return front;
}

}  // namespace raylab
