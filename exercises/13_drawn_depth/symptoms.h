#pragma once

#include "questions.h"
#include "symptom.h"

#include <optional>
#include <vector>

// What wrong answers to this exercise have in common.

namespace raylab::grading::drawing_depth {

inline Arguments of(const Case& question) { return arguments(question.input); }
inline bool is_of(const Case& question, const std::string& group) { return question.group.starts_with(group); }
inline bool claims(const WrongAnswer& w) { return w.given[0] == 1; }
inline bool covers(const WrongAnswer& w) { return w.right[0] == 1; }

/// Both say that the place is covered, so that only the depth is wrong.
inline bool has_other_depth(const WrongAnswer& w) { return claims(w) && covers(w); }

/// A depth by another mean of the three: of transformed depths, by some weights.
template <class There, class Back>
Symptom another_mean(const std::string& hint, const std::string& words, const There& there, const Back& back) {
    return {hint, words, [there, back](const WrongAnswer& w) {
                if (!has_other_depth(w)) return false;
                const auto given = of(w.question);
                const auto share = picture_weights(given);
                long double sum = 0;
                for (std::size_t i = 0; i < 3; ++i)
                    sum += share[i] * there(static_cast<long double>(given.corners[i].depth));
                return is_same(w.given[1], static_cast<double>(back(sum)));
            }};
}

/// The mean of the three depths, each weighing its share in the picture times this.
template <class Weight>
Symptom weighted_mean(const std::string& hint, const std::string& words, const Weight& weight) {
    return {hint, words, [weight](const WrongAnswer& w) {
                if (!has_other_depth(w)) return false;
                const auto given = of(w.question);
                const auto share = picture_weights(given);
                long double sum = 0, weights = 0;
                for (std::size_t i = 0; i < 3; ++i) {
                    const long double depth = given.corners[i].depth, its = share[i] * weight(depth);
                    sum += its * depth;
                    weights += its;
                }
                return is_same(w.given[1], static_cast<double>(sum / weights));
            }};
}

/// 1 / depth by the right weights at other corners.
inline bool has_weights_in_order(const WrongAnswer& w, const std::array<std::size_t, 3>& order) {
    if (!has_other_depth(w)) return false;
    const auto given = of(w.question);
    const auto share = picture_weights(given);
    long double near = 0, linear = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        near += share[i] / given.corners[order[i]].depth;
        linear += share[i] * given.corners[order[i]].depth;
    }
    return is_same(w.given[1], static_cast<double>(1 / near)) || is_same(w.given[1], static_cast<double>(linear));
}

/// How a depth is mixed between two places: by itself, as nobody should, or by 1 / depth.
using Mix = long double (*)(long double from, long double to, long double share);
inline long double by_depth(long double from, long double to, long double share) { return from + share * (to - from); }
inline long double by_nearness(long double from, long double to, long double share) {
    return 1 / by_depth(1 / from, 1 / to, share);
}

/// The depth at the place as a scanline has it: mixed along the two edges that the line crosses, and then along the
/// line, which runs in this direction of the picture.
inline std::optional<double> depth_by_lines(const Arguments& given, double way_x, double way_y, Mix edge, Mix line) {
    struct End {
        long double along, depth;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &from = given.corners[i], &to = given.corners[(i + 1) % 3];
        const auto off = [&](const DrawnCorner& c) {
            return (static_cast<long double>(c.x) - given.x) * way_y -
                   (static_cast<long double>(c.y) - given.y) * way_x;
        };
        const auto along = [&](const DrawnCorner& c) {
            return (static_cast<long double>(c.x) - given.x) * way_x +
                   (static_cast<long double>(c.y) - given.y) * way_y;
        };
        const long double off_from = off(from), off_to = off(to);
        if (off_from == off_to || (off_from > 0) == (off_to > 0)) continue;
        const long double share = off_from / (off_from - off_to);
        ends.push_back({by_depth(along(from), along(to), share), edge(from.depth, to.depth, share)});
    }
    if (ends.size() != 2) return std::nullopt;
    const long double share = ends[0].along / (ends[0].along - ends[1].along);
    return static_cast<double>(line(ends[0].depth, ends[1].depth, share));
}

/// Whether the depth is mixed in two steps of which one is right and the other is not, along lines in some direction.
inline bool is_mixed_by_lines(const WrongAnswer& w) {
    if (!has_other_depth(w)) return false;
    const auto given = of(w.question);
    const auto gives = [&](double way_x, double way_y) {
        const auto right_edges = depth_by_lines(given, way_x, way_y, by_nearness, by_depth);
        const auto right_lines = depth_by_lines(given, way_x, way_y, by_depth, by_nearness);
        return (right_edges && is_same(w.given[1], *right_edges)) || (right_lines && is_same(w.given[1], *right_lines));
    };
    return gives(1, 0) || gives(0, 1) || std::ranges::any_of(given.corners, [&](const DrawnCorner& corner) {
               return gives(corner.x - given.x, corner.y - given.y);
           });
}

/// On which way round the corners are drawn.
inline bool is_clockwise(const Case& question) {
    const auto s = sides(of(question));
    return s[0] <= 0 && s[1] <= 0 && s[2] <= 0;
}
inline bool is_covered(const Case& question) { return truth(of(question)).has_value(); }
inline bool is_on_an_edge(const Case& question) {
    const auto s = sides(of(question));
    return is_covered(question) && (s[0] == 0 || s[1] == 0 || s[2] == 0);
}
inline bool has_small_numbers(const Case& question) {
    const auto given = of(question);
    const auto& [p, q, r] = given.corners;
    return std::max({std::abs(p.x - q.x), std::abs(q.x - r.x), std::abs(r.x - p.x)}) < 1e-3;
}
inline bool has_large_numbers(const Case& question) {
    const auto given = of(question);
    const auto& [p, q, r] = given.corners;
    return std::max({std::abs(p.x - q.x), std::abs(q.x - r.x), std::abs(r.x - p.x)}) > 1e4;
}
inline double mean_depth(const WrongAnswer& w) {
    const auto given = of(w.question);
    return (given.corners[0].depth + given.corners[1].depth + given.corners[2].depth) / 3;
}
inline bool is_a_corner_depth(const WrongAnswer& w) {
    const auto given = of(w.question);
    return std::ranges::any_of(given.corners, [&](const DrawnCorner& c) { return is_same(w.given[1], c.depth); });
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"edge_on", "the triangle is seen edge-on, and has no area",
         [](const WrongAnswer& w) { return is_of(w.question, "seen edge-on"); }});
    add({"orientation", "the corners go round one way, and you say that the place is not covered",
         [](const WrongAnswer& w) { return covers(w) && !claims(w) && is_clockwise(w.question); },
         [](const Case& q) { return is_covered(q) && is_clockwise(q); }});
    add({"orientation", "the corners go round one way, and you say that the place is not covered",
         [](const WrongAnswer& w) { return covers(w) && !claims(w) && !is_clockwise(w.question); },
         [](const Case& q) { return is_covered(q) && !is_clockwise(q); }});
    add({"edges", "the place lies on an edge or at a corner, and you say that it is not covered",
         [](const WrongAnswer& w) { return is_on_an_edge(w.question) && !claims(w); }});
    add({"small", "the triangle is far smaller than a millionth of a unit, and you say that the place is not covered",
         [](const WrongAnswer& w) { return has_small_numbers(w.question) && covers(w) && !claims(w); },
         [](const Case& q) { return has_small_numbers(q) && is_covered(q); }});
    add({"small",
         "the triangle is far smaller than a millionth of a unit, and you say that a place beside it is covered",
         [](const WrongAnswer& w) { return has_small_numbers(w.question) && !covers(w) && claims(w); },
         [](const Case& q) { return has_small_numbers(q) && !is_covered(q); },
         [](const WrongAnswer& w) { return has_large_numbers(w.question) && covers(w) && !claims(w); }});
    add({"reciprocal", "your depth is 1 / the right one",
         [](const WrongAnswer& w) { return has_other_depth(w) && is_same(w.given[1] * w.right[1], 1); }});
    add(another_mean(
        "linear", "your depth is the mean of the three depths by their shares in the picture",
        [](long double z) { return z; }, [](long double sum) { return sum; }));
    add(another_mean(
        "linear", "your depth is the mean of another power of the depths", [](long double z) { return z * z; },
        [](long double sum) { return std::sqrt(sum); }));
    add(another_mean(
        "linear", "your depth is the mean of another power of the depths", [](long double z) { return 1 / (z * z); },
        [](long double sum) { return 1 / std::sqrt(sum); }));
    add(another_mean(
        "linear", "your depth is the mean of the depths' logarithms", [](long double z) { return std::log(z); },
        [](long double sum) { return std::exp(sum); }));
    add(weighted_mean("linear", "your depth is a mean whose weights are multiplied by the depths",
                      [](long double z) { return z; }));
    add(weighted_mean("linear", "the corners' shares are divided by their depths twice",
                      [](long double z) { return 1 / (z * z); }));
    add({"linear", "your depth is mixed right along the edges and not on the line between them, or the other way round",
         is_mixed_by_lines});
    for (const auto& order : {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}})
        add({"weights", "the corners' shares have changed places",
             [order](const WrongAnswer& w) { return has_weights_in_order(w, order); }});
    add({"corner_depth", "your depth is that of one of the corners, whatever the place",
         [](const WrongAnswer& w) { return has_other_depth(w) && is_a_corner_depth(w); }});
    add({"corner_depth", "your depth is a mean of the three, whatever the place", [](const WrongAnswer& w) {
             if (!has_other_depth(w)) return false;
             const auto given = of(w.question);
             const auto& [p, q, r] = given.corners;
             return is_same(w.given[1], mean_depth(w)) ||
                    is_same(w.given[1], 3 / (1 / p.depth + 1 / q.depth + 1 / r.depth));
         }});
    add({"normalised", "your depth is off by the triangle's area or a power of it", [](const WrongAnswer& w) {
             if (!has_other_depth(w)) return false;
             const auto given = of(w.question);
             const auto& [p, q, r] = given.corners;
             const double area = std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
             const double factor = std::abs(w.given[1] / w.right[1]);
             return is_same(factor, area) || is_same(factor * area, 1) || is_same(2 * factor, area) ||
                    is_same(factor * area, 2);
         }});
    add({"normalised", "your depth is half or twice the right one", [](const WrongAnswer& w) {
             return has_other_depth(w) && (is_same(2 * w.given[1], w.right[1]) || is_same(w.given[1], 2 * w.right[1]));
         }});
    add({"outside", "the place is beside the triangle, and you give a depth",
         [](const WrongAnswer& w) { return claims(w) && !covers(w); }});
    return of_numbers(std::move(all), {"edge_on"});
}

}  // namespace raylab::grading::drawing_depth
