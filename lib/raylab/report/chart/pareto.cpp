#include "raylab/report/chart/pareto.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace raylab {

namespace {

bool is_number(const Tradeoff& point) { return !std::isnan(point.error) && !std::isnan(point.time.median); }

bool faster(const Spread& a, const Spread& b) { return a.median < b.median && !tied(a, b); }

bool beats(const Tradeoff& a, const Tradeoff& b) {
    return is_number(a) &&
           ((a.error <= b.error && faster(a.time, b.time)) || (a.error < b.error && !faster(b.time, a.time)));
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const Tradeoff> points) {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto beaten = [&](const Tradeoff& other) { return beats(other, points[i]); };
        if (is_number(points[i]) && std::ranges::none_of(points, beaten)) front.push_back(i);
    }
    std::ranges::stable_sort(front, {},
                             [&](std::size_t i) { return std::tuple(points[i].error, points[i].time.median); });
    return front;
}

}  // namespace raylab
