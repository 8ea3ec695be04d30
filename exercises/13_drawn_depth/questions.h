#pragma once

#include "truth.h"
#include "whole_numbers.h"

// The cases. A triangle is made first, and the place is put by its weights in the picture.

namespace raylab::grading::drawing_depth {

inline bool is_fat(const Arguments& given) {
    const auto& [p, q, r] = given.corners;
    const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    const double size = std::max(
        {std::hypot(q.x - p.x, q.y - p.y), std::hypot(r.x - q.x, r.y - q.y), std::hypot(p.x - r.x, p.y - r.y)});
    return std::abs(area) > 0.1 * size * size;
}

/// A triangle of the picture, its corners in either order, at these depths.
template <class Depth>
Arguments triangle(Dice& dice, const Depth& depth) {
    for (;;) {
        const Vec3d center = dice.point(0, 200);
        Arguments given{};
        for (DrawnCorner& corner : given.corners) {
            const Vec3d off = dice.point(-60, 60);
            corner = {center.x + off.x, center.y + off.y, depth(dice)};
        }
        if (is_fat(given)) return given;
    }
}

/// Puts the place where the corners have these shares.
inline Arguments at_shares(Arguments given, double a, double b) {
    const auto& [p, q, r] = given.corners;
    given.x = a * p.x + b * q.x + (1 - a - b) * r.x;
    given.y = a * p.y + b * q.y + (1 - a - b) * r.y;
    return given;
}

inline Arguments inside(Dice& dice, const Arguments& given) {
    const double a = dice.in(0.05, 0.9), b = (0.95 - a) * dice.in(0.05, 1);
    return at_shares(given, a, b);
}

inline Arguments facing(Dice& dice) {
    const double depth = dice.in(1, 20);
    return inside(dice, triangle(dice, [depth](Dice&) { return depth; }));
}
inline Arguments slanted(Dice& dice) {
    return inside(dice, triangle(dice, [](Dice& d) { return d.in(2, 8); }));
}
inline Arguments far_away(Dice& dice) {
    return inside(dice, triangle(dice, [](Dice& d) { return std::exp(d.in(0, 7)); }));
}

inline Arguments outside(Dice& dice) {
    const Arguments given = triangle(dice, [](Dice& d) { return d.in(2, 8); });
    for (;;) {
        const double a = dice.in(-1, 2), b = dice.in(-1, 2);
        const Arguments asked = at_shares(given, a, b);
        if (std::min({a, b, 1 - a - b}) < -0.01 && keeps_margin(asked)) return asked;
    }
}

/// In the rectangle about the triangle, and beside it.
inline Arguments hardly_outside(Dice& dice) {
    for (;;) {
        const Arguments given = outside(dice);
        const auto& [p, q, r] = given.corners;
        const auto [left, right] = std::minmax({p.x, q.x, r.x});
        const auto [low, high] = std::minmax({p.y, q.y, r.y});
        if (given.x > left && given.x < right && given.y > low && given.y < high) return given;
    }
}

/// In units so small, or depths so small or large, that no number is near 1.
inline Arguments other_units(Dice& dice) {
    Arguments given = heads(dice) ? slanted(dice) : hardly_outside(dice);
    const double unit = heads(dice) ? 1e-18 : 1e5, depth = heads(dice) ? 1e-7 : 1e7;
    given.x *= unit;
    given.y *= unit;
    for (auto& [x, y, z] : given.corners) x *= unit, y *= unit, z *= depth;
    return given;
}

// On edges, in numbers that no correct formula rounds: shares of quarters, of an edge whose length is a multiple of
// four both ways, and depths that are powers of two.

inline Arguments whole_triangle(Dice& dice) {
    for (;;) {
        Arguments given{};
        for (auto& [x, y, depth] : given.corners) {
            x = 4 * whole(dice, -20, 20);
            y = 4 * whole(dice, -20, 20);
            depth = power_of_two(dice, -1, 4);
        }
        if (is_fat(given)) return given;
    }
}

inline Arguments on_an_edge(Dice& dice) {
    const double share = whole(dice, 1, 3) / 4.0;
    const int edge = whole(dice, 0, 2);
    return at_shares(whole_triangle(dice), edge == 0 ? 0 : share, edge == 1 ? 0 : edge == 0 ? share : 1 - share);
}

/// On the line of an edge, beyond one of its ends.
inline Arguments beyond_an_edge(Dice& dice) {
    const double share = heads(dice) ? -whole(dice, 1, 3) / 4.0 : 1 + whole(dice, 1, 3) / 4.0;
    const int edge = whole(dice, 0, 2);
    return at_shares(whole_triangle(dice), edge == 0 ? 0 : share, edge == 1 ? 0 : edge == 0 ? share : 1 - share);
}

inline Arguments at_a_corner(Dice& dice) {
    const int corner = whole(dice, 0, 2);
    return at_shares(whole_triangle(dice), corner == 0 ? 1 : 0, corner == 1 ? 1 : 0);
}

/// The third corner lies on the line of the two others, and so does the place, mostly.
inline Arguments edge_on(Dice& dice) {
    Arguments given = whole_triangle(dice);
    auto& [p, q, r] = given.corners;
    const double share = whole(dice, 0, 4) / 4.0;
    r.x = p.x + share * (q.x - p.x);
    r.y = p.y + share * (q.y - p.y);
    const double at = whole(dice, 0, 4) / 4.0;
    given.x = p.x + at * (q.x - p.x);
    given.y = p.y + at * (q.y - p.y);
    return given;
}

inline Arguments hardly_on_an_edge(Dice& dice) {
    const double share = dice.in(0.1, 0.9), off = dice.in(-1e-16, 1e-16);
    return at_shares(triangle(dice, [](Dice& d) { return d.in(2, 8); }), off, share);
}

}  // namespace raylab::grading::drawing_depth
