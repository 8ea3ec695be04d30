#pragma once

#include "arguments.h"

#include <algorithm>
#include <cmath>

// The truth by points: a half is visited where one of the two ends of the ray's part lies in it. It is computed in long
// double, and which half comes first follows from where the ray begins and ends, not from the sign of its direction.

namespace raylab::grading::halves {

inline long double place(const Arguments& given, double t) {
    if (given.direction == 0) return given.origin;  // also where t is infinite
    return given.origin + static_cast<long double>(t) * given.direction;
}

/// Where the ray reaches the plane: of rays that are not parallel to it.
inline long double crossing(const Arguments& given) {
    return (static_cast<long double>(given.plane) - given.origin) / given.direction;
}

inline std::vector<VisitedHalf> truth(const Arguments& given) {
    const auto& [origin, direction, plane, range] = given;
    const long double first = place(given, range.min), last = place(given, range.max);
    const auto t = [&](double limit) {
        return std::clamp(direction == 0 ? limit : static_cast<double>(crossing(given)), range.min, range.max);
    };
    const bool rises = first <= last;
    std::vector<VisitedHalf> visited;
    if (std::min(first, last) <= plane)
        visited.push_back({CellHalf::below, rises ? Interval<double>{range.min, t(range.max)}
                                                  : Interval<double>{t(range.min), range.max}});
    if (std::max(first, last) >= plane)
        visited.push_back({CellHalf::above, rises ? Interval<double>{t(range.min), range.max}
                                                  : Interval<double>{range.min, t(range.max)}});
    if (!rises) std::ranges::reverse(visited);
    return visited;
}

inline bool is_same(double a, double b, double size) { return a == b || std::abs(a - b) <= 1e-9 * size; }

inline bool is_same(const VisitedHalf& a, const VisitedHalf& b) {
    const auto finite = [](double x) { return std::isfinite(x) ? std::abs(x) : 0; };
    const double size = std::max(finite(b.range.min), finite(b.range.max));
    return a.half == b.half && is_same(a.range.min, b.range.min, size) && is_same(a.range.max, b.range.max, size);
}

inline bool is_same(const std::vector<VisitedHalf>& a, const std::vector<VisitedHalf>& b) {
    return std::ranges::equal(a, b, [](const auto& one, const auto& other) { return is_same(one, other); });
}

/// Whether an answer is right. A ray in the plane is in both halves all along, and comes to neither first.
inline bool is_right(const Arguments& given, std::span<const double> answer) {
    if (answer[0] > 2) return false;
    std::vector<VisitedHalf> expected = truth(given), said = read_halves(answer);
    if (is_same(said, expected)) return true;
    if (given.direction != 0) return false;
    std::ranges::reverse(said);
    return is_same(said, expected);
}

}  // namespace raylab::grading::halves
