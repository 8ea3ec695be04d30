#pragma once

#include "lens_shares.h"
#include "point_patterns.h"
#include "symptom.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// What wrong answers to this exercise have in common.

namespace raylab::grading::lens {

/// The points of a wrong answer, as shares of the lens.
struct Points {
    std::span<const double> given;
    LensCase lens;
    std::vector<DrawnShare> shares = lens_shares(given, lens.radius);

    double x(std::size_t i) const { return given[2 * i] / lens.radius; }
    double y(std::size_t i) const { return given[2 * i + 1] / lens.radius; }

    /// The distance of the farthest one from the centre, in radii.
    double farthest() const { return std::sqrt(std::ranges::max(shares, {}, &DrawnShare::inside).inside); }
    std::vector<NumberPair> numbers() const { return number_pairs(lens.which); }

    template <class Which>
    double share_of(const Which& which) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < pairs; ++i) count += which(i);
        return static_cast<double>(count) / static_cast<double>(pairs);
    }
};

inline Symptom pattern(const std::string& hint, const std::string& words, bool (*shows)(const Points&)) {
    return {hint, words, [shows](const WrongAnswer& w) { return shows(Points{w.given, lens_case(w.question)}); }};
}

/// Whether the points fill a lens of this radius instead. A grid is too coarse to tell whether they do so evenly.
inline bool fill_a_lens(const Points& points, double radius) {
    const Points others{points.given, {radius, points.lens.which}};
    return others.farthest() > 0.98 && others.farthest() <= 1 + 1e-9 &&
           (!are_spread(points.lens.which) || have_even_insides(others.shares));
}

/// Whether each point is as far from the centre as one of its two numbers from the middle of the square's side,
/// doubled.
inline bool have_coordinates_for_distances(const Points& points) {
    const auto numbers = points.numbers();
    const auto are = [&](double NumberPair::*number) {
        for (std::size_t i = 0; i < pairs; ++i)
            if (!(std::abs(std::sqrt(points.shares[i].inside) - std::abs(2 * (numbers[i].*number) - 1)) < 1e-7))
                return false;
        return true;
    };
    return are(&NumberPair::u) || are(&NumberPair::v);
}

/// Whether the points fill an ellipse that is longer along one axis than along the other, and evenly. Of an even
/// ellipse the mean of x^2 is a quarter of its half axis, squared.
inline bool fill_an_ellipse(const Points& points) {
    double across = 0, up = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        across += 4 * points.x(i) * points.x(i) / static_cast<double>(pairs);
        up += 4 * points.y(i) * points.y(i) / static_cast<double>(pairs);
    }
    if (!(across > 0 && up > 0) || std::abs(std::log(across / up)) < 0.1) return false;
    std::vector<DrawnShare> round;
    for (std::size_t i = 0; i < pairs; ++i) {
        const double x = points.x(i) / std::sqrt(across), y = points.y(i) / std::sqrt(up);
        round.push_back({x * x + y * y, turn_share(x, y)});
    }
    if (!are_spread(points.lens.which)) return std::ranges::max(round, {}, &DrawnShare::inside).inside < 1.1;
    return have_even_insides(round) && have_even_turns(round);
}

/// Whether all directions are alike, and not only on the whole: near the centre, and near the rim.
inline bool are_turns_alike(const Points& points) {
    std::vector<DrawnShare> inner, outer;
    for (const auto& point : points.shares) (point.inside < 0.5 ? inner : outer).push_back(point);
    const auto alike = [](const std::vector<DrawnShare>& some) {
        return some.size() < pairs_in_set || have_even_turns(some);
    };
    return have_even_turns(points.shares) && alike(inner) && alike(outer);
}

/// Whether the square from -1 to 1 is bent into the lens by x sqrt(1 - y^2 / 2), and y by the same.
inline bool is_bent_square(const Points& points) {
    const auto numbers = points.numbers();
    for (std::size_t i = 0; i < pairs; ++i) {
        const double a = 2 * numbers[i].u - 1, b = 2 * numbers[i].v - 1;
        const double one = std::abs(a) * std::sqrt(1 - b * b / 2), other = std::abs(b) * std::sqrt(1 - a * a / 2);
        const double x = std::abs(points.x(i)), y = std::abs(points.y(i));
        const auto same = [](double p, double q) { return std::abs(p - q) < 1e-7; };
        if (!(same(x, one) && same(y, other)) && !(same(x, other) && same(y, one))) return false;
    }
    return true;
}

/// Whether the square from -1 to 1 is the lens where it lies on it, and only what sticks out was moved.
inline bool is_square_on_the_lens(const Points& points) {
    const auto numbers = points.numbers();
    std::size_t inside = 0, kept = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        const double across = std::abs(2 * numbers[i].u - 1), up = std::abs(2 * numbers[i].v - 1);
        if (std::hypot(across, up) > 1) continue;
        const double x = std::abs(points.x(i)), y = std::abs(points.y(i));
        const auto same = [](double a, double b) { return std::abs(a - b) < 1e-7; };
        ++inside;
        kept += (same(x, across) && same(y, up)) || (same(x, up) && same(y, across));
    }
    return static_cast<double>(kept) > 0.99 * static_cast<double>(inside);
}

inline bool is_on_the_lens(const Points& points) { return points.farthest() <= 1 + 1e-9; }

inline double square_root(double inside) { return std::sqrt(inside); }

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](const std::string& hint, const std::string& words, bool (*shows)(const Points&)) {
        all.push_back(pattern(hint, words, shows));
    };
    const auto add_radius = [&](const std::string& hint, const std::string& words, double (*radius_of)(double)) {
        all.push_back({hint, words,
                       [radius_of](const WrongAnswer& w) {
                           const Points points{w.given, lens_case(w.question)};
                           return fill_a_lens(points, radius_of(points.lens.radius));
                       },
                       [](const Case& q) { return q.input[0] != 1; }});
    };
    add("nothing_at_the_centre", "the only point that is no number is that of u = v = 1/2", [](const Points& p) {
        const auto numbers = p.numbers();
        std::size_t lost = 0;
        for (std::size_t i = 0; i < pairs; ++i) {
            if (std::isfinite(p.shares[i].inside)) continue;
            if (numbers[i].u != 0.5 || numbers[i].v != 0.5) return false;
            ++lost;
        }
        return lost > 0;
    });
    add("rim", "all points lie on the rim", [](const Points& p) {
        return p.share_of([&](std::size_t i) { return std::abs(p.shares[i].inside - 1) < 1e-9; }) == 1;
    });
    add("cosine_twice", "all points lie on a line, where both coordinates are of one size", [](const Points& p) {
        return p.share_of([&](std::size_t i) { return agree(std::abs(p.x(i)), std::abs(p.y(i))); }) == 1;
    });
    add("square_pulled_in", "as many points as a square's corners have lie on the rim itself, or in the very centre",
        [](const Points& p) {
            const double moved = p.share_of(
                [&](std::size_t i) { return std::abs(p.shares[i].inside - 1) < 1e-9 || p.shares[i].inside == 0; });
            return std::abs(moved - (1 - std::numbers::pi / 4)) < spread_noise;  // as many as the corners have
        });
    add("square_pulled_in", "the points are a square's, and only those of its corners were moved",
        [](const Points& p) { return is_on_the_lens(p) && is_square_on_the_lens(p); });
    add("whole_steps", "the points have only some directions from the centre, or only some distances",
        [](const Points& p) { return are_spread(p.lens.which) && have_whole_steps(p.shares); });
    add("square", "the points fill a square", [](const Points& p) {
        const bool within =
            p.share_of([&](std::size_t i) { return std::max(std::abs(p.x(i)), std::abs(p.y(i))) <= 1 + 1e-9; }) == 1;
        return within && p.farthest() > 1.3;
    });
    add("diameter", "the points fill a lens of twice the radius",
        [](const Points& p) { return fill_a_lens(p, 2 * p.lens.radius); });
    add("radius_halved", "the points fill a lens of half the radius",
        [](const Points& p) { return fill_a_lens(p, p.lens.radius / 2); });
    add_radius("radius_forgotten", "the points fill a lens of radius 1, whatever its radius is",
               [](double) { return 1.0; });
    add_radius("radius_under_the_root", "the points fill a lens whose radius is the root of the right one",
               [](double radius) { return std::sqrt(radius); });
    add_radius("radius_squared", "the points fill a lens whose radius is the square of the right one",
               [](double radius) { return radius * radius; });
    add("ellipse", "the points fill an ellipse, longer along one axis than along the other", fill_an_ellipse);
    add("same_number_twice", "all points lie on one curve",
        [](const Points& p) { return is_on_the_lens(p) && lie_on_a_curve(p.shares); });
    add("pi_by_hand", "the angle goes as a number times a pi of a few digits",
        [](const Points& p) { return turn_by_a_rounded_pi(p.shares, p.numbers()); });
    add("degrees", "the angle is in degrees", [](const Points& p) { return turn_by_degrees(p.shares, p.numbers()); });
    add("part_of_a_turn", "in some directions from the centre there is no point",
        [](const Points& p) { return is_on_the_lens(p) && leave_out_turns(p.shares); });
    add("bent_square", "the points are a square's, each coordinate made shorter where the other is long",
        is_bent_square);
    add("not_independent", "distances are right, and directions are right, but not together", [](const Points& p) {
        return are_spread(p.lens.which) && is_on_the_lens(p) && have_even_insides(p.shares) &&
               have_even_turns(p.shares) && !are_turns_alike(p);
    });
    add("columns", "the points are even from left to right, or from below to above", [](const Points& p) {
        std::vector<double> columns, rows;
        for (std::size_t i = 0; i < pairs; ++i) {
            columns.push_back((p.x(i) + 1) / 2);
            rows.push_back((p.y(i) + 1) / 2);
        }
        // (Of a hemisphere's shadow both are even.)
        return is_on_the_lens(p) && are_even(std::move(columns)) != are_even(std::move(rows));
    });
    add("one_wedge", "each distance is a coordinate of the square, and the directions are not even",
        [](const Points& p) { return have_coordinates_for_distances(p) && !have_even_turns(p.shares); });
    add("sqrt_forgotten", "the distances from the centre are even",
        [](const Points& p) { return have_even_insides_by(p.shares, square_root) && have_even_turns(p.shares); });
    add("cube_root", "the distances are those of points in a ball", [](const Points& p) {
        return have_even_insides_by(p.shares, [](double inside) { return inside * std::sqrt(inside); });
    });
    add("crowd_at_the_centre", "all directions are alike, and more points than belong there are near the centre",
        [](const Points& p) {
            return is_on_the_lens(p) && are_turns_alike(p) && mean_inside(p.shares) < 0.5 - spread_noise;
        });
    add("crowd_at_the_rim", "all directions are alike, and more points than belong there are near the rim",
        [](const Points& p) {
            return is_on_the_lens(p) && are_turns_alike(p) && mean_inside(p.shares) > 0.5 + spread_noise;
        });
    add("uneven_turn", "the distances are right, and some directions are more frequent than others",
        [](const Points& p) {
            return are_spread(p.lens.which) && have_even_insides(p.shares) && !have_even_turns(p.shares);
        });
    return all;
}

}  // namespace raylab::grading::lens
