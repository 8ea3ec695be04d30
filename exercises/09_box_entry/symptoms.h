#pragma once

#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <cmath>

// What wrong answers to this exercise have in common.

namespace raylab::grading::boxes {

inline Arguments of(const Case& question) { return arguments(question.input); }

inline bool says_none(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 0; }
inline bool says_hit(const WrongAnswer& w) { return w.right[0] == 0 && w.given[0] == 1; }
inline bool both_hit(const WrongAnswer& w) { return w.right[0] == 1 && w.given[0] == 1; }

/// The same ray without ends: where its line enters the box and leaves it; from > to where it never does.
struct Passage {
    double from, to;
};
inline Passage passage(const Case& question) {
    const auto [ray, low, high] = of(question);
    Passage passage{-1e300, 1e300};
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0) {
            if (o < low[axis] || o > high[axis]) return {1, 0};
            continue;
        }
        const double a = (low[axis] - o) / d, b = (high[axis] - o) / d;
        passage = {std::max(passage.from, std::min(a, b)), std::min(passage.to, std::max(a, b))};
    }
    return passage;
}

inline bool begins_inside(const Case& question) {
    const auto [from, to] = passage(question);
    const double start = of(question).ray.range.min;
    return from < start && start < to;
}

/// Whether the start (t = 0) is in the box, and the point at which the range begins is not.
inline bool starts_inside_only(const Case& question) {
    const auto given = of(question);
    return is_inside(given, 0, 3) && !is_inside(given, given.ray.range.min, 3);
}

inline bool is_parallel(const Case& question) {
    const auto& d = of(question).ray.direction;
    return d.x == 0 || d.y == 0 || d.z == 0;
}
inline bool is_in_face(const Case& question) {
    const auto [ray, low, high] = of(question);
    for (int axis = 0; axis < 3; ++axis)
        if (ray.direction[axis] == 0 && (ray.origin[axis] == low[axis] || ray.origin[axis] == high[axis])) return true;
    return false;
}
inline bool is_flat(const Case& question) {
    const auto [ray, low, high] = of(question);
    return low.x == high.x || low.y == high.y || low.z == high.z;
}
inline bool goes_backward(const Case& question) {
    const auto& d = of(question).ray.direction;
    return d.x < 0 || d.y < 0 || d.z < 0;
}
/// Neither very short nor very long, so that t has about the size of the scene.
inline bool is_of_common_length(const Case& question) {
    const double length = glm::length(of(question).ray.direction);
    return length > 1e-6 && length < 1e6;
}
inline bool is_short(const Case& question) { return glm::length(of(question).ray.direction) < 1e-6; }

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"not_a_number", "a coordinate of the direction is 0, and you give no number",
         [](const WrongAnswer& w) { return std::isnan(w.given[1]) && is_parallel(w.question); }});
    add({"start_for_range", "the start is in the box, and you give range.min, where the ray is outside",
         [](const WrongAnswer& w) {
             return starts_inside_only(w.question) && w.given[0] == 1 && w.given[1] == of(w.question).ray.range.min;
         },
         starts_inside_only});
    add({"closed_range", "the range ends on a face of the box", [](const WrongAnswer& w) {
             const auto [from, to] = passage(w.question);
             return says_none(w) && (from == of(w.question).ray.range.max || to == of(w.question).ray.range.min);
         }});
    add({"closed", "the box is without thickness, or the ray runs in a face, and you give none",
         [](const WrongAnswer& w) { return says_none(w) && (is_flat(w.question) || is_in_face(w.question)); },
         [](const Case& q) { return is_flat(q) || is_in_face(q); }});
    add({"not_a_number", "the ray runs in the plane of a face, where (plane - origin) / 0 is 0 / 0",
         [](const WrongAnswer& w) {
             return is_in_face(w.question) && (!is_flat(w.question) || std::isnan(w.given[1]));
         }});
    add({"closed", "the box is without thickness, or the ray runs in a face, and you give none",
         [](const WrongAnswer& w) { return says_none(w) && (is_flat(w.question) || is_in_face(w.question)); }});
    add({"closed", "the box is without thickness, or a range or a ray only touches it", [](const WrongAnswer& w) {
             const auto [from, to] = passage(w.question);
             return says_none(w) && (is_flat(w.question) || is_in_face(w.question) ||
                                     from == of(w.question).ray.range.max || to == of(w.question).ray.range.min);
         }});
    add({"small_is_not_zero", "the direction is a billionth long",
         [](const WrongAnswer& w) { return is_short(w.question); }});
    add({"inside", "the range begins inside the box, and you give where the ray leaves it", [](const WrongAnswer& w) {
             return both_hit(w) && begins_inside(w.question) && agree(w.given[1], passage(w.question).to);
         }});
    add({"inside", "the range begins inside the box, and you give none",
         [](const WrongAnswer& w) { return says_none(w) && begins_inside(w.question); }, begins_inside});
    add({"distance", "you give t times the length of the direction",
         [](const WrongAnswer& w) {
             const double length = glm::length(of(w.question).ray.direction);
             return both_hit(w) && length != 1 && agree(w.given[1], w.right[1] * length);
         },
         [](const Case& q) {
             return std::abs(glm::length(of(q).ray.direction) - 1) > 1e-6 && first_inside(of(q)).value_or(0) != 0;
         }});
    add({"entry", "you give where the ray leaves the box",
         [](const WrongAnswer& w) { return both_hit(w) && agree(w.given[1], passage(w.question).to); }});
    add({"from_zero_on", "the range begins before the start, and yours begins at 0", [](const WrongAnswer& w) {
             const double start = of(w.question).ray.range.min;
             return start != 0 && w.given[0] == 1 ? std::abs(w.given[1]) < 1e-9 : start < 0 && says_none(w);
         }});
    add({"inside", "the range begins inside the box, and you do not give its beginning",
         [](const WrongAnswer& w) { return begins_inside(w.question); }, begins_inside});
    add({"range", "you give a t outside the range", [](const WrongAnswer& w) {
             const auto& range = of(w.question).ray.range;
             return w.given[0] == 1 && !contains(range, w.given[1]);
         }});
    add({"range", "the line goes through the box outside the range, and you give a hit",
         [](const WrongAnswer& w) { return says_hit(w) && passage(w.question).from <= passage(w.question).to; }});
    add({"parallel", "a coordinate of the direction is 0",
         [](const WrongAnswer& w) { return is_parallel(w.question); }});
    add({"backward", "a coordinate of the direction is negative",
         [](const WrongAnswer& w) { return goes_backward(w.question); },
         [](const Case& q) {
             const auto [from, to] = passage(q);
             const auto& range = of(q).ray.range;
             return goes_backward(q) && from < to && from > range.min && from < range.max;
         },
         [](const WrongAnswer& w) { return goes_backward(w.question); }});
    add({"all_three",
         "the line goes past the box, and you give a hit",
         [](const WrongAnswer& w) {
             const auto [from, to] = passage(w.question);
             return says_hit(w) && from > to && is_of_common_length(w.question);
         },
         {},
         [](const WrongAnswer& w) { return says_hit(w); }});
    add({"all_three",
         "you give a hit where the ray is not in all three slabs, or too early",
         [](const WrongAnswer& w) {
             return is_of_common_length(w.question) && (says_hit(w) || (both_hit(w) && w.given[1] < w.right[1]));
         },
         {},
         [](const WrongAnswer& w) { return says_hit(w) || (both_hit(w) && w.given[1] < w.right[1]); }});
    add({"latest_entry", "you give a t later than the entry",
         [](const WrongAnswer& w) { return both_hit(w) && w.given[1] > w.right[1]; }});
    return of_numbers(std::move(all), {"not_a_number"});
}

}  // namespace raylab::grading::boxes
