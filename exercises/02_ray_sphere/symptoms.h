#pragma once

#include "crossings.h"

#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::ray_sphere {

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"root_of_negative", "the line misses the sphere, and t is no number",
         [](const WrongAnswer& w) { return std::isnan(w.given[1]) && !line_hits(w.question); }});
    add({"distance", "t is as many times too large as the direction is long: a distance",
         [](const WrongAnswer& w) { return should_hit(w) && gives(w, w.right[1] * length_of(w.question)); },
         [](const Case& q) { return line_hits(q) && !is_unit(q) && counts(q, near_root(q)); }});
    add({"far_root", "t is where the ray leaves the sphere, and it enters inside the range", [](const WrongAnswer& w) {
             return should_hit(w) && agree(w.right[1], near_root(w.question)) && gives(w, far_root(w.question));
         }});
    add({"infinite_end", "the range begins at -infinity, and you give none, or no number",
         [](const WrongAnswer& w) {
             return std::isinf(range_of(w.question).min) && should_hit(w) &&
                    (gives_none(w) || !std::isfinite(w.given[1]));
         },
         [](const Case& q) { return std::isinf(range_of(q).min) && hits(q); }});
    // At one of its ends, or at both.
    const auto is_at_end = [&](const auto& is_at) {
        add({"closed_range", "the hit is exactly at an end of the range",
             [is_at](const WrongAnswer& w) { return should_hit(w) && is_at(range_of(w.question), w.right[1]); },
             [is_at](const Case& q) { return hits(q) && is_at(range_of(q), first_hit(q)); }});
    };
    is_at_end([](const Interval<double>& range, double t) { return t == range.min || t == range.max; });
    is_at_end([](const Interval<double>& range, double t) { return t == range.min; });
    is_at_end([](const Interval<double>& range, double t) { return t == range.max; });
    add({"own_limits",
         "the hit is at the range's beginning or less than a thousandth after it, and you give a later one, or none",
         [](const WrongAnswer& w) {
             return should_hit(w) && w.right[1] - range_of(w.question).min < 1e-3 &&
                    (gives_none(w) || gives(w, far_root(w.question)));
         }});
    add({"range_in_metres", "you compare distances in metres with the range, and give t in the direction's lengths",
         [](const WrongAnswer& w) { return gives_by_metres(w.question, w.given); },
         [](const Case& q) { return !is_right_by_metres(q); },
         [](const WrongAnswer& w) { return gives_none(w) && !is_unit(w.question); }});
    add({"tangent", "the ray touches the sphere, and you give no hit", [](const WrongAnswer& w) {
             return gives_none(w) && quadratic(arguments(w.question.input)).discriminant() == 0;
         }});
    add({"inside", "the ray enters before its range begins and leaves inside it, and you give no hit",
         [](const WrongAnswer& w) { return should_hit(w) && gives_none(w) && agree(w.right[1], far_root(w.question)); },
         [](const Case& q) { return line_hits(q) && !counts(q, near_root(q)) && counts(q, far_root(q)); }});
    add({"inside", "the ray enters before its range begins, and you give that hit or the range's beginning",
         [](const WrongAnswer& w) {
             return should_hit(w) && agree(w.right[1], far_root(w.question)) && near_root(w.question) >= -1e9 &&
                    gives(w, std::max(near_root(w.question), range_of(w.question).min));
         },
         [](const Case& q) { return line_hits(q) && !counts(q, near_root(q)) && counts(q, far_root(q)); }});
    add({"inside", "the ray starts inside the sphere, and you give no hit, or the range's beginning",
         [](const WrongAnswer& w) {
             return starts_inside(w.question) && (gives_none(w) || gives(w, range_of(w.question).min));
         },
         [](const Case& q) { return starts_inside(q) && counts(q, far_root(q)); }});
    // Which root it is tells its sign, not the range; where both are negative, the far one is taken.
    add({"inside", "the near crossing lies after the start and before the range, and you do not try the far one",
         [](const WrongAnswer& w) {
             return should_hit(w) && gives_none(w) && agree(w.right[1], far_root(w.question)) &&
                    near_root(w.question) > 0;
         },
         [](const Case& q) {
             return line_hits(q) && near_root(q) > 0 && !counts(q, near_root(q)) && counts(q, far_root(q));
         },
         [](const WrongAnswer& w) { return should_hit(w) && w.right[1] < 0 && gives(w, far_root(w.question)); }});
    add({"behind", "you give a hit that is not inside the range",
         [](const WrongAnswer& w) { return w.given[0] == 1 && !counts(w.question, w.given[1]); }});
    add({"center_behind", "the sphere's centre lies behind the start, and you give no hit",
         [](const WrongAnswer& w) { return gives_none(w) && is_center_behind(w.question); },
         [](const Case& q) { return is_center_behind(q) && counts(q, far_root(q)); }});
    add({"center_behind", "the sphere's centre lies beyond the range's end, and you give no hit",
         [](const WrongAnswer& w) { return should_hit(w) && gives_none(w) && is_center_beyond(w.question); },
         [](const Case& q) { return is_center_beyond(q) && counts(q, near_root(q)); }});
    add({"one_of_two", "only the first crossing is inside the range, and you give no hit",
         [](const WrongAnswer& w) {
             return gives_none(w) && counts(w.question, near_root(w.question)) &&
                    !counts(w.question, far_root(w.question));
         },
         [](const Case& q) { return line_hits(q) && counts(q, near_root(q)) && !counts(q, far_root(q)); }});
    add({"own_limits", "the hit is at a t below 0, where the range begins before the start",
         [](const WrongAnswer& w) { return should_hit(w) && w.right[1] < 0; },
         [](const Case& q) { return hits(q) && first_hit(q) < 0; }});
    add({"own_limits", "the hit is at a t of less than a hundredth, or of more than a thousand, and you give none",
         [](const WrongAnswer& w) {
             return should_hit(w) && gives_none(w) && (w.right[1] < 0.01 || w.right[1] > 500);
         }});
    add({"own_epsilon", "the discriminant is smaller than a thousandth, and you give no hit", [](const WrongAnswer& w) {
             return should_hit(w) && gives_none(w) && quadratic(arguments(w.question.input)).discriminant() < 1e-3;
         }});
    add({"own_epsilon", "the discriminant is smaller than a thousandth, and you take it for 0",
         [](const WrongAnswer& w) {
             const auto q = quadratic(arguments(w.question.input));
             return should_hit(w) && q.discriminant() < 1e-3 && gives(w, -q.b / q.a);
         }});
    add({"from_center", "t is one of the two crossings with the sign turned", gives_a_turned_one,
         // Else only crossings behind the start are turned: a size is taken of them.
         [](const Case& q) { return line_hits(q) && counts(q, near_root(q)); }, gives_a_turned_one});
    const auto formula = [&](const std::string& hint, const std::string& words, auto other) {
        add(by(hint, words, other));
    };
    // Where a direction is of length 1 to seven digits, each of its powers is: that case is no evidence of which.
    formula("precedence", "t is (-b -+ root) / 2 * a, which multiplies by a", [](const Arguments& g) {
        auto q = quadratic(g);
        q.m = 1 / (q.a * q.a);
        return q;
    });
    for (const double twice : {1.0, 2.0}) {  // b = f.d, or 2 f.d as in most books
        const auto brackets_left_out = [twice](const Arguments& g) {
            const auto q = quadratic(g);
            const double root = std::sqrt(q.discriminant()) / q.a;
            return std::array{-twice * q.b - root, -twice * q.b + root};
        };
        add(by_crossings("brackets", "t is -b -+ (root / a): the division takes the root alone", brackets_left_out));
    }
    add(by_crossings("brackets", "t is (-b -+ sqrt((b^2 - a c) / a)) / a: a stands under the root, too",
                     [](const Arguments& g) {
                         const auto q = quadratic(g);
                         const double root = std::sqrt(q.discriminant() / q.a);
                         return std::array{(-q.b - root) / q.a, (-q.b + root) / q.a};
                     }));
    add(by_crossings("distance", "t is a distance in metres, wherever the direction is not of length 1",
                     [](const Arguments& g) {
                         const auto q = quadratic(g);
                         const double length = std::sqrt(q.a);
                         return std::array{length * q.root(-1), length * q.root(1)};
                     }));
    none_speaks_for(all.back());
    all.back().where = [](const Case& q) { return line_hits(q) && !is_unit(q); };
    all.back().allows = [](const WrongAnswer& w) { return is_unit(w.question); };
    add(by_crossings("unit_direction", "t is -b / a -+ half the chord in metres", [](const Arguments& g) {
        const auto q = quadratic(g);
        const double half = std::sqrt(q.discriminant() / q.a);
        return std::array{-q.b / q.a - half, -q.b / q.a + half};
    }));
    // Directions rounded to floats are of length 1 to seven digits.
    add({"unit_direction", "t is right to some digits where the direction is of length 1, and wrong where it is not",
         [](const WrongAnswer& w) {
             const double off = w.given[0] == w.right[0] ? std::abs(w.given[1] / w.right[1] - 1) : 1;
             return is_unit(w.question) ? off < 0.05 : off > 1e-5;
         },
         [](const Case& q) { return line_hits(q) && length_of(q) != 1 && counts(q, near_root(q)); }});
    all.back().allows = all.back().shows;
    auto turned =
        by_crossings("from_center", "t is one of the two crossings with the sign turned", [](const Arguments& g) {
            const auto q = quadratic(g);
            return std::array{-q.root(1), -q.root(-1)};
        });
    none_speaks_for(turned);
    turned.where = [](const Case& q) { return line_hits(q) && counts(q, near_root(q)); };
    add(turned);
    const std::string mixed = "t is that of two conventions, mixed";
    formula("half_b", mixed, [](const Arguments& g) {
        return Quadratic{quadratic(g).a, quadratic(g).b, quadratic(g).c, 4, 1};
    });
    formula("half_b", mixed, [](const Arguments& g) {
        return Quadratic{quadratic(g).a, quadratic(g).b, quadratic(g).c, 4, 2};
    });
    formula("half_b", mixed, [](const Arguments& g) {
        return Quadratic{quadratic(g).a, quadratic(g).b, quadratic(g).c, 1, 2};
    });
    formula("half_b", mixed, [](const Arguments& g) {
        return Quadratic{quadratic(g).a, 2 * quadratic(g).b, quadratic(g).c, 4, 1};
    });
    formula("half_b", mixed, [](const Arguments& g) {
        return Quadratic{quadratic(g).a, 2 * quadratic(g).b, quadratic(g).c, 1, 2};
    });
    formula("radius_squared", "the sphere is one of another radius: r where r^2 belongs", [](const Arguments& g) {
        auto q = quadratic(g);
        q.c += g.sphere.radius * g.sphere.radius - g.sphere.radius;
        return q;
    });
    // Who gives none here and there has another fault than another sphere: it shows where the right one is hit.
    add(by_crossings("radius_squared", "the sphere has a radius of 0", [](const Arguments& g) {
        auto q = quadratic(g);
        q.c += g.sphere.radius * g.sphere.radius;
        return std::array{q.root(-1), q.root(1)};
    }));
    all.back().where = hits;
    formula("center", "the sphere is one at the origin", [](const Arguments& g) {
        return quadratic({g.ray, {{0, 0, 0}, g.sphere.radius}});
    });
    all.back().where = hits;
    formula("center", "the sphere is one on the other side of the origin", [](const Arguments& g) {
        return quadratic({g.ray, {-g.sphere.center, g.sphere.radius}});
    });
    all.back().where = hits;
    add(by_crossings("square_root", "t is (-b -+ discriminant) / a: without the root", [](const Arguments& g) {
        const auto q = quadratic(g);
        return std::array{(-q.b - q.discriminant()) / q.a, (-q.b + q.discriminant()) / q.a};
    }));
    none_speaks_for(all.back());
    return of_numbers(std::move(all), {"root_of_negative", "infinite_end"});
}

}  // namespace raylab::grading::ray_sphere
