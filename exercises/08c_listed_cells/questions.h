#pragma once

#include "truth.h"
#include "whole_numbers.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

// The cases. Each is made in the coordinates of its face, and drawn again until it is what its group says.

namespace raylab::grading::listing {

inline Vec3d placed(int face, double u, double v, double w) {
    Vec3d p{0};
    p[face / 2] = face % 2 == 0 ? w : -w;
    p[(face / 2 + 1) % 3] = u;
    p[(face / 2 + 2) % 3] = v;
    return p;
}

inline bool is_in_front(const Arguments& given) {
    return std::ranges::all_of(given.corners, [&](const Vec3d& p) { return seen_by(p, given.face).w > 0.05L; });
}

/// The light is not on the polygon, nor near its plane.
inline bool is_off_the_light(const Arguments& given) {
    const auto& corners = given.corners;
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    return std::abs(dot(normal, corners[0])) > 0.05 * glm::length(normal);
}

/// A convex polygon about a point: corners on a circle in any plane, in order, either way round.
inline Arguments about(Dice& dice, const Vec3d& center, double radius, int face, int resolution) {
    const Vec3d normal = dice.direction(), other = dice.direction();
    const Vec3d right = glm::normalize(cross(normal, other)), up = cross(normal, right);
    const int count = whole(dice, 3, 5);
    const double turn = dice.in(0, 6), way = sign(dice);
    Arguments given{{}, face, resolution};
    for (int i = 0; i < count; ++i) {
        const double angle = way * (turn + (i + dice.in(-0.3, 0.3)) * 2 * std::numbers::pi / count);
        given.corners.push_back(center + radius * (std::cos(angle) * right + std::sin(angle) * up));
    }
    return given;
}

/// Of a size that suits the group, at a place of the face from -reach to reach.
inline Arguments anywhere(Dice& dice, double reach, double smallest, double largest) {
    const int face = whole(dice, 0, 5), resolution = whole(dice, 5, 16);
    const double w = dice.in(0.5, 3), u = w * dice.in(-reach, reach), v = w * dice.in(-reach, reach);
    return about(dice, placed(face, u, v, w), w * dice.in(smallest, largest), face, resolution);
}

/// Drawn again until it is sharp, and as the group says.
template <class Next, class Fits>
Arguments drawn(Dice& dice, const Next& next, const Fits& fits) {
    for (;;) {
        const Arguments given = next(dice);
        if (is_off_the_light(given) && fits(given) && keeps_margin(given)) return given;
    }
}

inline bool is_within_the_face(const Arguments& given) {
    const auto is_inside = [&](const Vec3d& p) {
        const Seen seen = seen_by(p, given.face);
        return std::abs(seen.u) < seen.w && std::abs(seen.v) < seen.w;
    };
    return is_in_front(given) && std::ranges::all_of(given.corners, is_inside);
}

/// The part of the face from the smallest to the largest image of a corner, as if all of them were seen.
inline Window window_of_corners(const Arguments& given) {
    Window all;
    for (const Vec3d& corner : given.corners) {
        const auto [u, v, w] = seen_by(corner, given.face);
        all = {std::min(all.left, u / w), std::max(all.right, u / w), std::min(all.low, v / w),
               std::max(all.high, v / w)};
    }
    return all;
}
inline std::optional<CellRectangle> cells_of_corners(const Arguments& given) {
    return cells_of(window_of_corners(given), given.resolution);
}

inline bool is_seen(const Arguments& given) { return truth(given).has_value(); }
inline bool reaches_behind(const Arguments& given) {
    const auto w = [&](const Vec3d& p) { return seen_by(p, given.face).w; };
    return std::ranges::any_of(given.corners, [&](const Vec3d& p) { return w(p) < -0.05L; }) &&
           std::ranges::any_of(given.corners, [&](const Vec3d& p) { return w(p) > 0.05L; });
}

inline Arguments within_the_face(Dice& dice) {
    return drawn(
        dice, [](Dice& d) { return anywhere(d, 0.7, 0.1, 0.6); }, is_within_the_face);
}

inline Arguments over_the_edge(Dice& dice) {
    return drawn(
        dice, [](Dice& d) { return anywhere(d, 1, 0.3, 0.9); },
        [](const Arguments& given) {
            return is_in_front(given) && is_seen(given) && !is_within_the_face(given) &&
                   truth(given) == cells_of_corners(given);
        });
}

/// In front of the light, and what sticks out of the face would still widen the rectangle.
inline Arguments past_a_corner(Dice& dice) {
    return drawn(
        dice, [](Dice& d) { return anywhere(d, 1.3, 0.3, 0.9); },
        [](const Arguments& given) {
            return is_in_front(given) && is_seen(given) && truth(given) != cells_of_corners(given);
        });
}

inline Arguments behind_in_part(Dice& dice) {
    return drawn(
        dice, [](Dice& d) { return anywhere(d, 1.2, 0.8, 2.5); },
        [](const Arguments& given) { return reaches_behind(given) && is_seen(given); });
}

/// A triangle with a corner as deep as the light itself, where w is exactly 0.
inline Arguments level_with_the_light(Dice& dice) {
    return drawn(
        dice,
        [](Dice& d) {
            Arguments given = anywhere(d, 1, 0.8, 2);
            given.corners.resize(3);
            given.corners[0][given.face / 2] = 0;
            return given;
        },
        is_seen);
}

inline Arguments fills_the_face(Dice& dice) {
    return drawn(
        dice, [](Dice& d) { return anywhere(d, 0.3, 2, 5); },
        [](const Arguments& given) {
            return truth(given) == CellRectangle{0, given.resolution - 1, 0, given.resolution - 1};
        });
}

/// How many corners the polygon has at most while it is cut at the pyramid's sides, in any order of them.
inline std::size_t corners_while_cut(const Arguments& given) {
    std::array<int, 4> sides{0, 1, 2, 3};
    std::size_t most = given.corners.size();
    do {
        std::vector<Seen> corners;
        for (const Vec3d& corner : given.corners) corners.push_back(seen_by(corner, given.face));
        for (const int side : sides) {
            const auto above = [side](const Seen& p) {
                return p.w + (side < 2 ? p.u : p.v) * (side % 2 == 0 ? -1 : 1);
            };
            std::vector<Seen> left;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Seen &a = corners[i], &b = corners[(i + 1) % corners.size()];
                if (above(a) >= 0) left.push_back(a);
                if (above(a) * above(b) < 0) left.push_back(between(a, b, above(a) / (above(a) - above(b))));
            }
            corners = left;
            most = std::max(most, corners.size());
        }
    } while (std::ranges::next_permutation(sides).found);
    return most;
}

/// About as large as the face: what is left has corners of its own, and more where the face's sides cut it.
inline Arguments with_many_corners(Dice& dice) {
    return drawn(
        dice, [](Dice& d) { return anywhere(d, 0.4, 0.9, 1.5); },
        [](const Arguments& given) { return is_seen(given) && corners_while_cut(given) > 6; });
}

/// Nothing is seen: the polygon is behind the light, or beside the face's pyramid, or both.
inline Arguments elsewhere(Dice& dice) {
    const double side = sign(dice);
    return drawn(
        dice,
        [side](Dice& d) {
            Arguments given = anywhere(d, 2, 0.3, 1.5);
            if (side > 0) given.face ^= 1;
            return given;
        },
        [](const Arguments& given) { return !is_seen(given); });
}

/// Lengths from a millionth to a million: the cells are the same.
inline Arguments any_length(Dice& dice) {
    Arguments given = heads(dice) ? within_the_face(dice) : behind_in_part(dice);
    const double length = heads(dice) ? 1e-6 : 1e6;
    for (Vec3d& corner : given.corners) corner *= length;
    return given;
}

inline Arguments one_cell(Dice& dice) {
    Arguments given = heads(dice) ? behind_in_part(dice) : elsewhere(dice);
    given.resolution = 1;
    return given;
}

// On borders, in numbers that no correct formula rounds: the resolution, and every w, is a power of two.

/// A rectangle or a triangle of these places of the face, at depths that are the same along its lower and its upper
/// edge.
inline Arguments upright(Dice& dice, double left, double right, double low, double high) {
    const int face = whole(dice, 0, 5);
    const double lower = power_of_two(dice, -2, 2), upper = power_of_two(dice, -2, 2);
    Arguments given{{placed(face, left * lower, low * lower, lower), placed(face, right * lower, low * lower, lower),
                     placed(face, right * upper, high * upper, upper)},
                    face,
                    8};
    if (heads(dice)) given.corners.push_back(placed(face, left * upper, high * upper, upper));
    if (heads(dice)) std::ranges::reverse(given.corners);
    return given;
}

/// Ends of the polygon lie in borders between cells.
inline Arguments at_a_border(Dice& dice) {
    const int left = whole(dice, 1, 3), right = whole(dice, 4, 7), low = whole(dice, 1, 3), high = whole(dice, 4, 7);
    const auto place = [](int border) { return border / 4.0 - 1; };
    return upright(dice, place(left), place(right), place(low), place(high));
}

/// Beside the face, which it touches in one of its edges, or within, up to that edge.
inline Arguments at_the_edge(Dice& dice) {
    const double side = sign(dice), low = whole(dice, -3, -1) / 4.0, high = whole(dice, 1, 3) / 4.0;
    const double far = side * (heads(dice) ? 1.5 : 0.375);
    return upright(dice, std::min(side, far), std::max(side, far), low, high);
}

/// Off a border between cells by a few roundings.
inline Arguments hardly_at_a_border(Dice& dice) {
    Arguments given = at_a_border(dice);
    given.resolution = 7;
    for (Vec3d& corner : given.corners) corner *= 1 + dice.in(-1e-15, 1e-15);
    for (std::size_t i = 0; i < given.corners.size(); ++i) {
        auto& u = given.corners[i][(given.face / 2 + 1) % 3];
        const auto w = static_cast<double>(seen_by(given.corners[i], given.face).w);
        u = w * (std::round((u / w + 1) / 2 * 7) * 2 / 7 - 1);
    }
    return given;
}

}  // namespace raylab::grading::listing
