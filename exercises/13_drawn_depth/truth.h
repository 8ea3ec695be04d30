#pragma once

#include "arguments.h"

#include <algorithm>
#include <cmath>

// The truth in space. With the eye at 0 a corner that is drawn at (x, y) in depth z stands at z (x, y, 1), and what is
// seen at a place is where the ray (x, y, 1) meets the triangle's plane. It is computed in long double; coordinates are
// taken from the place, so that none is large beside the triangle.

namespace raylab::grading::drawing_depth {

struct Point {
    long double x, y, z;
};

inline Point crossed(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double dotted(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The corners in space, seen so that the place is straight ahead.
inline std::array<Point, 3> corners_in_space(const Arguments& given) {
    const auto corner = [&](std::size_t i) {
        const auto& [x, y, depth] = given.corners[i];
        return Point{(static_cast<long double>(x) - given.x) * depth, (static_cast<long double>(y) - given.y) * depth,
                     depth};
    };
    return {corner(0), corner(1), corner(2)};
}

/// For each edge on which side of it the place is, by the plane through the edge and the eye: of one sign where the
/// place is covered.
inline std::array<long double, 3> sides(const Arguments& given) {
    const auto p = corners_in_space(given);
    const auto side = [&](std::size_t i) { return crossed(p[i], p[(i + 1) % 3]).z; };
    return {side(0), side(1), side(2)};
}

inline std::optional<double> truth(const Arguments& given) {
    const auto s = sides(given);
    const bool is_left = s[0] >= 0 && s[1] >= 0 && s[2] >= 0, is_right = s[0] <= 0 && s[1] <= 0 && s[2] <= 0;
    if (is_left == is_right) return std::nullopt;  // beside it, or all of them 0
    const auto p = corners_in_space(given);
    const auto from_first = [&](const Point& a) { return Point{a.x - p[0].x, a.y - p[0].y, a.z - p[0].z}; };
    const Point normal = crossed(from_first(p[1]), from_first(p[2]));
    if (normal.z == 0) return std::nullopt;
    return static_cast<double>(dotted(normal, p[0]) / normal.z);
}

/// The shares of the three corners in the picture at the place: 0 on the edge across from a corner.
inline std::array<long double, 3> picture_weights(const Arguments& given) {
    const auto s = sides(given);
    const auto& c = given.corners;
    const std::array<long double, 3> areas{s[1] / c[1].depth / c[2].depth, s[2] / c[2].depth / c[0].depth,
                                           s[0] / c[0].depth / c[1].depth};
    const long double sum = areas[0] + areas[1] + areas[2];
    return {areas[0] / sum, areas[1] / sum, areas[2] / sum};
}

/// Whether the place is off all edges' lines by a share of the triangle.
inline bool keeps_margin(const Arguments& given) {
    return std::ranges::all_of(picture_weights(given), [](long double share) { return std::abs(share) > 1e-3L; });
}

inline bool is_same(double a, double b) { return std::abs(a - b) <= 1e-8 * std::max(std::abs(a), std::abs(b)); }

}  // namespace raylab::grading::drawing_depth
