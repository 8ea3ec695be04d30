#pragma once

#include "arguments.h"
#include "symptom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::ray_triangle {

/// Where a ray's line meets the triangle's plane, by Cramer's rule in doubles.
struct Meeting {
    double determinant, t, u, v;
    bool is_inside() const { return u >= 0 && v >= 0 && u + v <= 1; }
};

inline Meeting meeting(const Case& question) {
    const auto [ray, triangle] = arguments(question.input);
    const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, s = ray.origin - triangle.a;
    const Vec3d p = cross(ray.direction, ac), q = cross(s, ab);
    const double determinant = dot(ab, p);
    return {determinant, dot(ac, q) / determinant, dot(s, p) / determinant, dot(ray.direction, q) / determinant};
}

inline Interval<double> range_of(const Case& question) { return {question.input[6], question.input[7]}; }
inline double length_of(const Case& question) {
    return std::hypot(question.input[3], question.input[4], question.input[5]);
}
inline bool is_unit(const Case& question) { return std::abs(length_of(question) - 1) < 1e-6; }
inline bool hits(const Case& question) {
    const auto m = meeting(question);
    return m.determinant != 0 && m.is_inside() && contains(range_of(question), m.t);
}
/// The ray through the point that has the direction for its coordinates.
inline Case through_the_direction(Case question) {
    for (std::size_t i = 0; i < 3; ++i) question.input[3 + i] -= question.input[i];
    return question;
}
inline double size_of(const Case& question) {
    const auto triangle = arguments(question.input).triangle;
    return std::max(glm::length(triangle.b - triangle.a), glm::length(triangle.c - triangle.a));
}

inline bool gives_none(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 0; }
inline bool gives_one(const WrongAnswer& w) { return w.right[0] == 0 && w.given[0] == 1; }
inline bool both_hit(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 1; }

inline bool is_parallel(const Case& question) { return meeting(question).determinant == 0; }

/// By how much both weights are too large; absent where it is not the same for both, or 1.
inline std::optional<double> factor_of_weights(const WrongAnswer& w) {
    const double by = w.given[2] / w.right[2];
    if (!both_hit(w) || agree(by, 1) || !agree(w.given[3], by * w.right[3])) return std::nullopt;
    return by;
}

/// Whether it is a determinant of the triangle, with the ray or by itself.
inline bool is_volume(double by, const Case& question) {
    const auto [ray, triangle] = arguments(question.input);
    const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    return agree(std::abs(by), std::abs(dot(normal, ray.direction))) || agree(by, dot(normal, normal));
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"parallel", "the ray runs parallel to the plane, and you give a hit or no number",
         [](const WrongAnswer& w) { return meeting(w.question).determinant == 0; }});
    add({"swapped", "u and v are two of the three weights, but not those of b and c", [](const WrongAnswer& w) {
             if (!both_hit(w) || !agree(w.right[1], w.given[1])) return false;
             if (agree(w.right[2], w.given[2]) && agree(w.right[3], w.given[3])) return false;
             const std::array weights{1 - w.right[2] - w.right[3], w.right[2], w.right[3]};
             const auto is_one = [&](double x) {
                 return std::ranges::any_of(weights, [x](double weight) { return std::abs(x - weight) < 1e-6; });
             };
             return is_one(w.given[2]) && is_one(w.given[3]);
         }});
    add({"unit_direction", "t is as many times too large as the direction is long: a distance",
         [](const WrongAnswer& w) { return both_hit(w) && agree(w.given[1], w.right[1] * length_of(w.question)); },
         [](const Case& q) { return hits(q) && !is_unit(q); }});
    // Weights that are off lose hits, and make some.
    const auto is_other_outcome = [](const WrongAnswer& w) {
        return w.given[0] != w.right[0] && !is_parallel(w.question);
    };
    add({"not_divided",
         "u and v are as many times too large, as if nothing had divided them",
         [](const WrongAnswer& w) {
             const auto by = factor_of_weights(w);
             return by && is_volume(*by, w.question);
         },
         {},
         is_other_outcome});
    add({"areas",
         "u and v are in proportion, and as many times too large, or too small",
         [](const WrongAnswer& w) { return factor_of_weights(w).has_value(); },
         {},
         is_other_outcome});
    add({"areas",
         "u and v are projections on the two edges",
         [](const WrongAnswer& w) {
             const auto [ray, triangle] = arguments(w.question.input);
             const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
             const Vec3d p = ray.origin + w.right[1] * ray.direction - triangle.a;
             return both_hit(w) && agree(w.given[2], dot(p, ab) / dot(ab, ab)) &&
                    agree(w.given[3], dot(p, ac) / dot(ac, ac));
         },
         {},
         is_other_outcome});
    add({"free_vector",
         "your hits and misses are those of a ray that goes from the origin to the direction, as to a point",
         [](const WrongAnswer& w) {
             const Case other = through_the_direction(w.question);
             if (!hits(other)) return w.given[0] == 0;
             const auto [determinant, t, u, v] = meeting(other);
             return w.given[0] == 1 && agree(w.given[1], t) && agree(w.given[2], u) && agree(w.given[3], v);
         },
         [](const Case& q) {
             const Case other = through_the_direction(q);
             return hits(q) != hits(other) || (hits(q) && !agree(meeting(q).t, meeting(other).t));
         }});
    const auto metres_are_in = [](const Case& q) { return contains(range_of(q), meeting(q).t * length_of(q)); };
    add({"range_in_metres", "you compare the distance in metres with the range, and not t",
         [metres_are_in](const WrongAnswer& w) {
             return meeting(w.question).is_inside() && w.given[0] == (metres_are_in(w.question) ? 1 : 0) &&
                    w.given[0] != w.right[0];
         },
         [metres_are_in](const Case& q) {
             const auto m = meeting(q);
             return m.determinant != 0 && m.is_inside() && metres_are_in(q) != contains(range_of(q), m.t);
         }});
    add({"culling", "the triangle is seen from one of its sides, and you give no hit", gives_none,
         [](const Case& q) { return hits(q) && meeting(q).determinant < 0; }});
    add({"culling", "the triangle is seen from one of its sides, and you give no hit", gives_none,
         [](const Case& q) { return hits(q) && meeting(q).determinant > 0; }});
    add({"infinite_end", "the range begins at -infinity, and you give none, or no number",
         [](const WrongAnswer& w) {
             return std::isinf(range_of(w.question).min) && w.right[0] == 1 &&
                    (w.given[0] == 0 || !std::isfinite(w.given[1]));
         },
         [](const Case& q) { return std::isinf(range_of(q).min) && hits(q); }});
    // At one of its ends, or at both.
    const auto is_at_end = [&](const auto& is_at) {
        add({"closed_range", "the hit is exactly at an end of the range",
             [is_at](const WrongAnswer& w) { return w.right[0] == 1 && is_at(range_of(w.question), w.right[1]); },
             [is_at](const Case& q) { return hits(q) && is_at(range_of(q), meeting(q).t); }});
    };
    is_at_end([](const Interval<double>& range, double t) { return t == range.min || t == range.max; });
    is_at_end([](const Interval<double>& range, double t) { return t == range.min; });
    is_at_end([](const Interval<double>& range, double t) { return t == range.max; });
    add({"closed_edges", "the hit is exactly on an edge or a vertex", [](const WrongAnswer& w) {
             return w.right[0] == 1 && (w.right[2] == 0 || w.right[3] == 0 || w.right[2] + w.right[3] == 1);
         }});
    add({"epsilon", "the triangle is smaller than a millimetre, and you give no hit",
         [](const WrongAnswer& w) { return gives_none(w) && size_of(w.question) < 1e-3; },
         [](const Case& q) { return hits(q) && size_of(q) < 1e-3; }});
    // A t that is small may be so for its triangle's sake: only in some of these cases.
    const auto begins_later = [&](const std::string& words, const auto& is_before) {
        add({"own_limits", words,
             [is_before](const WrongAnswer& w) { return gives_none(w) && is_before(range_of(w.question), w.right[1]); },
             [is_before](const Case& q) { return hits(q) && is_before(range_of(q), meeting(q).t); }});
    };
    begins_later("the hit is less than a thousandth after the range's beginning, and you give none",
                 [](const Interval<double>& range, double t) { return t - range.min < 1e-3; });
    begins_later("the hit is at a t of less than a thousandth, and you give none",
                 [](const Interval<double>&, double t) { return t < 1e-3; });
    begins_later("the hit is at a t below 0, where the range begins before the start",
                 [](const Interval<double>&, double t) { return t < 0; });
    add({"range", "the point is inside the triangle and its t outside the range, and you give a hit",
         [](const WrongAnswer& w) { return gives_one(w) && meeting(w.question).is_inside(); }});
    add({"range", "the range ends before the hit or begins after it, or it begins before the start",
         [](const WrongAnswer& w) {
             return meeting(w.question).is_inside() && (gives_one(w) || (gives_none(w) && w.right[1] < 0));
         }});
    add({"beyond_a_vertex", "the point is on the straight line of an edge, beyond its end, and you give a hit",
         [](const WrongAnswer& w) {
             const auto m = meeting(w.question);
             return gives_one(w) && !m.is_inside() && (m.u == 0 || m.v == 0 || m.u + m.v == 1);
         }});
    add({"own_tolerance",
         "the point is outside by less than a thousandth, of the triangle or of a metre, and you give a hit",
         [](const WrongAnswer& w) {
             const auto m = meeting(w.question);
             const bool is_near = std::min({m.u, m.v, 1 - m.u - m.v}) > -1e-3;
             return gives_one(w) && !m.is_inside() && (is_near || size_of(w.question) < 1e-3);
         }});
    add({"third_edge", "the point is beyond the third edge, and you give a hit", [](const WrongAnswer& w) {
             const auto m = meeting(w.question);
             return gives_one(w) && m.u >= 0 && m.v >= 0 && m.u + m.v > 1;
         }});
    add({"inside", "the point is outside the triangle, and you give a hit",
         [](const WrongAnswer& w) { return gives_one(w) && !meeting(w.question).is_inside(); }});
    add({"unit_direction", "the direction is not of length 1",
         [](const WrongAnswer& w) { return !is_unit(w.question); },
         [](const Case& q) { return hits(q) && !is_unit(q); }});
    add({"turned_sign", "t, u or v has the wrong sign", [](const WrongAnswer& w) {
             bool turned = false;
             for (const std::size_t i : {1u, 2u, 3u}) {
                 if (!agree(std::abs(w.right[i]), std::abs(w.given[i]))) return false;
                 turned = turned || !agree(w.right[i], w.given[i]);
             }
             return both_hit(w) && turned;
         }});
    add({"signs", "there is a hit, and you give none", gives_none, hits});
    return of_numbers(std::move(all), {"parallel", "infinite_end"});
}

}  // namespace raylab::grading::ray_triangle
