#pragma once

#include "questions.h"
#include "symptom.h"

#include <fmt/format.h>

// What wrong answers to this exercise have in common.

namespace raylab::grading::halves {

inline Arguments of(const Case& question) { return arguments(question.input); }

inline bool is_parallel(const Case& question) { return of(question).direction == 0; }
inline bool is_in_plane(const Case& question) {
    return is_parallel(question) && of(question).origin == of(question).plane;
}
inline bool is_touching(const Case& question) {
    const auto given = of(question);
    if (given.direction == 0) return false;
    const auto t = static_cast<double>(crossing(given));
    return t == given.range.min || t == given.range.max;
}
inline bool touches_at(const Case& question, bool begin) {
    const auto range = of(question).range;
    return is_touching(question) && static_cast<double>(crossing(of(question))) == (begin ? range.min : range.max);
}
inline bool is_before_start(const Case& question) {
    return of(question).range.min < 0 && !is_parallel(question) && crossing(of(question)) < 0;
}
inline bool falls(const Case& question) { return of(question).direction < 0; }
inline bool is_tiny(const Case& question) {
    const double size = std::abs(of(question).direction);
    return size > 0 && size < 1e-6;
}
inline bool has_common_length(const Case& question) {
    const double size = std::abs(of(question).direction);
    return size == 0 || (size > 1e-6 && size < 1e6);
}
inline bool crosses(const WrongAnswer& w) { return w.right[0] == 2; }

/// The halves of a ray that is not parallel, where another number is taken for t at the plane.
inline std::vector<VisitedHalf> halves_by(const Arguments& given, double t) {
    const auto near = given.direction > 0 ? CellHalf::below : CellHalf::above;
    const auto far = given.direction > 0 ? CellHalf::above : CellHalf::below;
    if (t > given.range.max) return {{near, given.range}};
    if (t < given.range.min) return {{far, given.range}};
    return {{near, {given.range.min, t}}, {far, {t, given.range.max}}};
}

/// The halves where the origin's side counts as the first one, and the other is behind where t is negative (or 0).
inline std::vector<VisitedHalf> halves_by_origin(const Arguments& given, bool zero_is_behind, bool plane_is_below) {
    const bool is_below = given.origin < given.plane || (given.origin == given.plane && plane_is_below);
    const CellHalf first = is_below ? CellHalf::below : CellHalf::above;
    const CellHalf second = is_below ? CellHalf::above : CellHalf::below;
    const double t = static_cast<double>(crossing(given));
    if (t > given.range.max || t < 0 || (zero_is_behind && t == 0)) return {{first, given.range}};
    if (t < given.range.min) return {{second, given.range}};
    return {{first, {given.range.min, t}}, {second, {t, given.range.max}}};
}

inline bool is_by_origin(const Arguments& given, const std::vector<VisitedHalf>& said) {
    if (given.direction == 0) return false;
    for (const bool behind : {false, true})
        for (const bool below : {false, true, given.direction <= 0, given.direction > 0})
            if (is_same(said, halves_by_origin(given, behind, below))) return true;
    return false;
}

/// The halves of a ray that counts as parallel to the plane.
inline std::vector<VisitedHalf> halves_if_parallel(const Arguments& given) {
    std::vector<VisitedHalf> visited;
    if (given.origin <= given.plane) visited.push_back({CellHalf::below, given.range});
    if (given.origin >= given.plane) visited.push_back({CellHalf::above, given.range});
    return visited;
}

/// Whether the answer is that of a parallel ray, or one of its halves, though the ray goes down the axis.
inline bool falls_and_counts_as_parallel(const WrongAnswer& w) {
    const auto given = of(w.question);
    const auto said = read_halves(w.given), flat = halves_if_parallel(given);
    return falls(w.question) && said.size() <= 2 &&
           (is_same(said, flat) || (flat.size() == 2 && said.size() == 1 && said[0].range.min == given.range.min &&
                                    said[0].range.max == given.range.max));
}

inline Symptom another_t(const std::string& words, double (*t)(const Arguments&)) {
    return {"t", words,
            [t](const WrongAnswer& w) {
                const auto given = of(w.question);
                return !is_parallel(w.question) && is_same(read_halves(w.given), halves_by(given, t(given)));
            },
            [t](const Case& q) {
                const auto given = of(q);
                return !is_parallel(q) && !is_same(truth(given), halves_by(given, t(given)));
            }};
}

/// Whether an answer has the right halves in the right order, and only the ranges are wrong.
inline bool has_right_halves(const WrongAnswer& w) {
    return w.given[0] == w.right[0] && w.given[1] == w.right[1] && (w.right[0] < 2 || w.given[4] == w.right[4]);
}

inline bool is_reversed(const WrongAnswer& w) {
    if (w.given[0] != w.right[0]) return false;
    return w.given[1] != w.right[1] && (w.right[0] < 2 || w.given[4] != w.right[4]);
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"in_plane", "the ray lies in the plane", [](const WrongAnswer& w) { return is_in_plane(w.question); }});
    add({"parallel", "the direction's coordinate is 0", [](const WrongAnswer& w) { return is_parallel(w.question); }});
    for (const bool at_begin : {false, true})
        add({"touch",
             fmt::format("the range {} exactly at the plane, and you visit one half", at_begin ? "begins" : "ends"),
             [=](const WrongAnswer& w) { return touches_at(w.question, at_begin) && w.given[0] == 1; },
             [=](const Case& q) { return touches_at(q, at_begin); },
             [](const WrongAnswer& w) {
                 return (is_in_plane(w.question) || is_touching(w.question)) && w.given[0] == 1;
             }});
    add({"parallel",
         "the direction's coordinate is 0",
         [](const WrongAnswer& w) { return is_parallel(w.question) && !is_in_plane(w.question); },
         {},
         [](const WrongAnswer& w) { return is_parallel(w.question) || (is_touching(w.question) && w.given[0] == 1); }});
    add({"touch", "the range begins or ends exactly at the plane, and you visit one half",
         [](const WrongAnswer& w) { return is_touching(w.question) && w.given[0] < 2; }});
    add({"small_is_not_zero", "the direction's coordinate is a billionth",
         [](const WrongAnswer& w) { return is_tiny(w.question); }});
    add({"before_start", "the plane is crossed before the start, at a negative t",
         [](const WrongAnswer& w) { return is_before_start(w.question); }});
    add({"before_start", "the origin's half comes first, and the other is visited where t at the plane is positive",
         [](const WrongAnswer& w) { return is_by_origin(of(w.question), read_halves(w.given)); },
         [](const Case& q) { return is_before_start(q) && !is_by_origin(of(q), truth(of(q))); },
         [](const WrongAnswer& w) { return is_by_origin(of(w.question), read_halves(w.given)); }});
    add({"less_than_epsilon", "the ray goes down the axis, and you answer as if it were parallel to the plane",
         falls_and_counts_as_parallel,
         [](const Case& q) { return falls(q) && !is_same(halves_if_parallel(of(q)), truth(of(q))); },
         [](const WrongAnswer& w) { return falls_and_counts_as_parallel(w) || is_tiny(w.question); }});
    auto cut_off = another_t("your t at the plane is not less than 0",
                             [](const Arguments& g) { return std::max(0.0, (g.plane - g.origin) / g.direction); });
    cut_off.hint = "before_start";
    add(cut_off);
    add({"ends_exchanged", "the two parts are those of the other half", [](const WrongAnswer& w) {
             if (w.given[0] != 2 || !crosses(w)) return false;
             return w.given[2] == w.right[5] && w.given[3] == w.right[6] && w.given[5] == w.right[2] &&
                    w.given[6] == w.right[3] && w.given[1] == w.right[1];
         }});
    add({"one_t", "the parts do not meet: there is a little gap between them, or they overlap",
         [](const WrongAnswer& w) {
             if (!has_right_halves(w) || !crosses(w)) return false;
             const auto said = read_halves(w.given);
             const auto range = of(w.question).range;
             const double t = w.right[3],
                          off = std::max(std::abs(said[0].range.max - t), std::abs(said[1].range.min - t));
             return said[0].range.max != said[1].range.min && off < 0.05 * std::min(t - range.min, range.max - t);
         }});
    add({"whole_range", "the halves are right, and their ranges are not cut at the plane", [](const WrongAnswer& w) {
             const auto range = of(w.question).range;
             if (!has_right_halves(w) || !crosses(w)) return false;
             const auto said = read_halves(w.given);
             return said[0].range.max == range.max || said[1].range.min == range.min;
         }});
    add({"far_forgotten", "the ray crosses the plane, and you visit one half",
         [](const WrongAnswer& w) { return crosses(w) && w.given[0] == 1; },
         [](const Case& q) { return !is_parallel(q) && truth(of(q)).size() == 2; }});
    add({"always_both",
         "the ray stays on one side of the plane, and you visit both halves",
         [](const WrongAnswer& w) { return !crosses(w) && w.given[0] >= 2 && has_common_length(w.question); },
         {},
         [](const WrongAnswer& w) { return !crosses(w) && w.given[0] >= 2; }});
    add({"nothing_visited", "you visit neither half", [](const WrongAnswer& w) { return w.given[0] == 0; }});
    add(another_t("your t is the distance from the plane, not divided by the direction",
                  [](const Arguments& g) { return g.plane - g.origin; }));
    add(another_t("your t is the distance to the plane, not divided by the direction's size",
                  [](const Arguments& g) { return (g.plane - g.origin) * (g.direction > 0 ? 1 : -1); }));
    add(another_t("your t is the distance from the plane times the direction",
                  [](const Arguments& g) { return (g.plane - g.origin) * g.direction; }));
    add(another_t("your t is divided by the size of the direction, and has lost its sign",
                  [](const Arguments& g) { return (g.plane - g.origin) / std::abs(g.direction); }));
    add(another_t("your t is never negative",
                  [](const Arguments& g) { return std::abs((g.plane - g.origin) / g.direction); }));
    add(another_t("your t has the other sign", [](const Arguments& g) { return (g.origin - g.plane) / g.direction; }));
    add(another_t("your t is plane / direction, without the origin",
                  [](const Arguments& g) { return g.plane / g.direction; }));
    add({"which_side", "the plane lies beyond the range or before it, and you visit the other half",
         [](const WrongAnswer& w) { return !crosses(w) && is_reversed(w) && !is_parallel(w.question); }});
    add({"order", "the ray goes down the axis, and you visit the halves from below to above",
         [](const WrongAnswer& w) { return falls(w.question) && w.given[1] == 0; }});
    add({"order", "the ray goes down the axis", [](const WrongAnswer& w) { return falls(w.question); }});
    add({"order", "you visit the halves in the other order",
         [](const WrongAnswer& w) { return !is_parallel(w.question) && crosses(w) && is_reversed(w); }});
    return of_numbers(std::move(all), {"in_plane", "parallel"});
}

}  // namespace raylab::grading::halves
