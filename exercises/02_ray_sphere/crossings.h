#pragma once

#include "arguments.h"
#include "symptom.h"

#include <array>
#include <cmath>
#include <optional>

// Where a line meets the sphere, rightly or by another formula, and what of that is inside the range.

namespace raylab::grading::ray_sphere {

/// A quadratic as somebody may have put it down: (-b -+ sqrt(b b - k a c)) / (m a).
struct Quadratic {
    double a, b, c, k = 1, m = 1;

    double discriminant() const { return b * b - k * a * c; }
    double root(double side) const { return (-b + side * std::sqrt(discriminant())) / (m * a); }
};

inline Quadratic quadratic(const Arguments& given) {
    const Vec3d f = given.ray.origin - given.sphere.center;
    const auto& d = given.ray.direction;
    return {dot(d, d), dot(f, d), dot(f, f) - given.sphere.radius * given.sphere.radius};
}

inline double length_of(const Case& question) { return std::sqrt(quadratic(arguments(question.input)).a); }
inline bool is_unit(const Case& question) { return std::abs(length_of(question) - 1) < 1e-6; }
inline double near_root(const Case& question) { return quadratic(arguments(question.input)).root(-1); }
inline double far_root(const Case& question) { return quadratic(arguments(question.input)).root(1); }
inline bool line_hits(const Case& question) { return quadratic(arguments(question.input)).discriminant() >= 0; }
inline Interval<double> range_of(const Case& question) { return {question.input[6], question.input[7]}; }
inline bool counts(const Case& question, double t) { return contains(range_of(question), t); }

/// The right answer, in doubles: whether there is a hit, and the first.
inline bool hits(const Case& question) {
    return line_hits(question) && (counts(question, near_root(question)) || counts(question, far_root(question)));
}
inline double first_hit(const Case& question) {
    return counts(question, near_root(question)) ? near_root(question) : far_root(question);
}

/// The middle of the chord lies beyond the range's end.
inline bool is_center_beyond(const Case& question) {
    const auto q = quadratic(arguments(question.input));
    return line_hits(question) && -q.b / q.a > range_of(question).max;
}
/// The middle of the chord lies before the ray's start.
inline bool is_center_behind(const Case& question) {
    return line_hits(question) && quadratic(arguments(question.input)).b > 0;
}
inline bool starts_inside(const Case& question) { return quadratic(arguments(question.input)).c < 0; }

inline bool gives(const WrongAnswer& wrong, double t) { return wrong.given[0] == 1 && agree(wrong.given[1], t); }
inline bool gives_none(const WrongAnswer& wrong) { return wrong.given[0] == 0; }
inline bool should_hit(const WrongAnswer& wrong) { return wrong.right[0] == 1; }

inline bool gives_a_turned_one(const WrongAnswer& wrong) {
    return line_hits(wrong.question) &&
           (gives(wrong, -near_root(wrong.question)) || gives(wrong, -far_root(wrong.question)));
}

/// The answer is one of two other crossings: crossings(arguments), the nearer first. None, where the range holds
/// neither, is what many mistakes give.
template <class Crossings>
Symptom by_crossings(const std::string& hint, const std::string& words, const Crossings& crossings) {
    return {hint,
            words,
            [crossings](const WrongAnswer& w) {
                const auto [near, far] = crossings(arguments(w.question.input));
                return gives(w, near) || gives(w, far);
            },
            {},
            [crossings](const WrongAnswer& w) {
                const auto [near, far] = crossings(arguments(w.question.input));
                if (std::isnan(w.given[1])) return std::isnan(near);
                return gives_none(w) && !counts(w.question, near) && !counts(w.question, far);
            }};
}

/// Where what comes out is far from right, the range holds it seldom: most answers are "none".
inline void none_speaks_for(Symptom& symptom) {
    symptom.shows = [gives = symptom.shows, none = symptom.allows](const WrongAnswer& w) {
        return gives(w) || none(w);
    };
    symptom.allows = {};
}

/// The first of two crossings that is inside the range; absent: none.
inline std::optional<double> first_inside(const Case& question, const std::array<double, 2>& crossings) {
    for (const double t : crossings)
        if (counts(question, t)) return t;
    return std::nullopt;
}

/// The answer that another quadratic leads to: it must be wrong wherever that is another one than the right one.
inline Symptom by(const std::string& hint, const std::string& words, Quadratic (*other)(const Arguments&)) {
    const auto crossings = [other](const Arguments& given) {
        const auto q = other(given);
        return std::array{q.root(-1), q.root(1)};
    };
    auto symptom = by_crossings(hint, words, crossings);
    none_speaks_for(symptom);
    symptom.where = [crossings](const Case& question) {
        const auto found = first_inside(question, crossings(arguments(question.input)));
        const auto right = first_inside(question, {near_root(question), far_root(question)});
        if (!found || !right) return found.has_value() != right.has_value();
        return std::abs(*found - *right) > 1e-9 * std::abs(*found);  // as it is judged
    };
    return symptom;
}

/// The first crossing whose distance in metres is inside the range, as a t; absent: none.
inline std::optional<double> first_by_metres(const Case& question) {
    if (!line_hits(question)) return std::nullopt;
    for (const double t : {near_root(question), far_root(question)})
        if (counts(question, t * length_of(question))) return t;
    return std::nullopt;
}
inline bool gives_by_metres(const Case& question, std::span<const double> given) {
    const auto t = first_by_metres(question);
    return t ? given[0] == 1 && agree(given[1], *t) : given[0] == 0;
}
/// Whether that is the first crossing inside the range.
inline bool is_right_by_metres(const Case& question) {
    return first_by_metres(question) == first_inside(question, {near_root(question), far_root(question)});
}

}  // namespace raylab::grading::ray_sphere
