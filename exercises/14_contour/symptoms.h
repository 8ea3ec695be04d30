#pragma once

#include "other_contours.h"
#include "symptom.h"

// What wrong answers to this exercise have in common.

namespace raylab::grading::contour {

inline Arguments of(const Case& question) { return arguments(question.input); }

inline bool is_cut(const Case& question) {
    const Heights height = heights(of(question));
    return height.least < 0 && height.most > 0;
}

inline Arguments turned(Arguments given) {
    std::ranges::reverse(given.polygon);
    return given;
}

/// Whether the polygon, or its back, gets any light.
inline bool is_lit(const Case& question) { return truth(of(question)) > 0 || truth(turned(of(question))) > 0; }

/// Whether the polygon is seen under a small angle.
inline bool is_small(const Case& question) {
    const Arguments given = of(question);
    double across = 0, near = std::numeric_limits<double>::infinity();
    for (const Vec3d& vertex : given.polygon) {
        across = std::max(across, glm::length(vertex - given.polygon[0]));
        near = std::min(near, glm::length(vertex - given.point));
    }
    return across < 0.01 * near;
}

inline constexpr double nothing = 1e-12;

/// The answer is this one, or 0 where this one is negative, or no more than rounding.
inline bool gives(const WrongAnswer& wrong, double value) {
    return agree(wrong.given[0], value) || (value < nothing && std::abs(wrong.given[0]) < nothing);
}

/// The answer is this one wherever it is wrong. That it is nothing where this one is nothing or negative, of a polygon
/// that the horizon cuts, is no evidence by itself: so it would be, too, if what the horizon cuts were left out.
inline Symptom by_value(const std::string& hint, const std::string& words,
                        const std::function<double(const Arguments&)>& other) {
    const auto shows = [other](const WrongAnswer& w) { return gives(w, other(of(w.question))); };
    return {
        hint,
        words,
        [shows](const WrongAnswer& w) { return !(std::abs(w.given[0]) < nothing && is_cut(w.question)) && shows(w); },
        {},
        shows};
}

inline Symptom instead(const std::string& hint, const std::string& words, double (*other)(const Arguments&)) {
    return by_value(hint, words, other);
}

/// The sum over the right contour, of other terms.
inline Symptom by_terms(const std::string& hint, const std::string& words, Term term) {
    return by_value(hint, words, [term](const Arguments& given) { return around(given, above_horizon(given), term); });
}

/// Of a polygon that is cut the list may begin anywhere, so any edge may be the last one.
inline bool lacks_last_edge(const WrongAnswer& wrong) {
    const Arguments given = of(wrong.question);
    const auto vertices = above_horizon(given);
    if (vertices.empty()) return false;
    const double all = around(given, vertices, of_edge);
    for (std::size_t i = is_cut(wrong.question) ? 0 : vertices.size() - 1; i < vertices.size(); ++i) {
        const long double edge = of_edge(Wide(given.normal), vertices[i], vertices[(i + 1) % vertices.size()]);
        if (gives(wrong, all - static_cast<double>(edge / (2 * std::numbers::pi_v<long double>)))) return true;
    }
    return false;
}

/// Whether the polygon faces the point, and its normal does not point against the patch's.
inline bool leans_away(const Case& question) {
    const Arguments given = of(question);
    Vec3d area{0, 0, 0};
    for (std::size_t i = 2; i < given.polygon.size(); ++i)
        area += cross(given.polygon[i - 1] - given.polygon[0], given.polygon[i] - given.polygon[0]);
    return truth(given) > 0 && dot(area, given.normal) >= 0;
}

/// Whether the answer is a sum to which some edges do not come, of a polygon that is seen in micrometres.
inline bool lacks_edges_of_a_tiny_one(const WrongAnswer& w) {
    const Arguments given = of(w.question);
    return is_tiny(given) && w.right[0] > 0 && std::ranges::any_of(sums_without_some_edges(given), [&](double sum) {
               return agree(w.given[0], sum) || (sum == 0 && std::abs(w.given[0]) < 1e-12);
           });
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto times = [&](const std::string& hint, const std::string& words, double factor) {
        add({hint, words, [factor](const WrongAnswer& w) { return agree(w.given[0], factor * w.right[0]); }});
    };
    times("two_pi_missing", "you give 2 pi times what is right", 2 * std::numbers::pi);
    times("pi_for_two_pi", "you give twice what is right", 2);
    times("factor", "you give half of what is right", 0.5);
    times("degrees", "you give 57.3 times what is right", 180 / std::numbers::pi);
    add({"behind_negative", "the polygon is seen from behind, and you give less than 0",
         [](const WrongAnswer& w) { return !is_in_front(of(w.question)) && w.given[0] < 0; }});
    add({"behind_counts", "the polygon is seen from behind, and you give what its front would get",
         [](const WrongAnswer& w) {
             return !is_in_front(of(w.question)) && agree(w.given[0], truth(turned(of(w.question))));
         }});
    add({"facing_by_normals", "the polygon's normal points to the same side as the patch's, and you give nothing",
         [](const WrongAnswer& w) { return leans_away(w.question) && std::abs(w.given[0]) < 1e-12; }, leans_away});
    add({"absolute_epsilon",
         "all is smaller than a millimetre, and you give a sum without some edges, or without all of them",
         lacks_edges_of_a_tiny_one, [](const Case& q) { return is_tiny(of(q)) && truth(of(q)) > 0; }});
    add(by_terms("asin",
                 "you give the sum with angles that an arc tangent makes negative, where they are more than 90 degrees",
                 [](const Wide& normal, const Wide& a, const Wide& b) {
                     const long double tangent = glm::length(cross(b, a)) / dot(a, b);
                     return std::atan(tangent) * slope(normal, a, b);
                 }));
    add({"turned", "you give the share with a minus, or none, of a front, or a share of a back",
         [](const WrongAnswer& w) {
             const bool in_front = is_in_front(of(w.question));
             return in_front ? w.given[0] == 0 || agree(w.given[0], -w.right[0]) : w.given[0] > 0;
         },
         is_lit});
    add({"acos", "the polygon is small and far, and you give no number, or one that is right to a few digits",
         [](const WrongAnswer& w) {
             return is_small(w.question) &&
                    (std::isnan(w.given[0]) || std::abs(w.given[0] - w.right[0]) < 0.1 * w.right[0]);
         },
         is_small});
    add(instead("no_horizon", "you give the sum over the whole contour, what is below the horizon included",
                [](const Arguments& given) { return around(given, not_cut(given), of_edge); }));
    add(instead("vertices_dropped", "you give the sum over the vertices above the horizon, with no crossings",
                [](const Arguments& given) { return around(given, without_those_below(given), of_edge); }));
    const std::string one_crossing = "you give the sum over a contour that lacks one of its two crossings";
    add(instead("vertices_dropped", one_crossing,
                [](const Arguments& given) { return around(given, with_crossings(given, true, false), of_edge); }));
    add(instead("vertices_dropped", one_crossing,
                [](const Arguments& given) { return around(given, with_crossings(given, false, true), of_edge); }));
    const std::string other_height = "you give the sum over a contour that is cut at another height than the point's";
    for (const int axis : {2, 1, 0})
        add(by_value("another_horizon", other_height, [axis](const Arguments& given) {
            const auto above = cut_by(given, [axis](const Wide& v) { return v[axis]; });
            return around(given, above, of_edge);
        }));
    add(instead("another_horizon", other_height, [](const Arguments& given) {
        const auto height = [&](const Wide& v) { return dot(Wide(given.normal), v + Wide(given.point)); };
        return around(given, cut_by(given, height), of_edge);
    }));
    add(instead("pushed_up", "you give the sum over vertices that were moved straight up to the horizon",
                [](const Arguments& given) { return around(given, pushed_up(given), of_edge); }));
    const auto cut_elsewhere = [&](const std::string& where, long double (*share)(long double from, long double to)) {
        add(by_value("crossing", "you give the sum over a contour that is cut " + where,
                     [share](const Arguments& given) { return around(given, cut_at(given, share), of_edge); }));
    };
    cut_elsewhere("in the middle of its edges", [](long double, long double) { return 0.5L; });
    cut_elsewhere("as far from one end of each edge as it should be from the other",
                  [](long double from, long double to) { return to / (to - from); });
    const std::string by_heights = "by a sum of two heights where their difference belongs, or by the wrong sign";
    cut_elsewhere(by_heights, [](long double from, long double to) { return from / (from + to); });
    cut_elsewhere(by_heights, [](long double from, long double to) { return to / (from + to); });
    cut_elsewhere(by_heights, [](long double from, long double to) { return from / (to - from); });
    // Without that edge the sum is never more than 0.
    add({"horizon_edge_forgotten", "you give the sum without the edge along the horizon, or nothing",
         [](const WrongAnswer& w) {
             const Arguments given = of(w.question);
             const Term without_ground = [](const Wide& normal, const Wide& a, const Wide& b) {
                 const bool along = std::abs(dot(normal, a)) <= 1e-12L * glm::length(a) &&
                                    std::abs(dot(normal, b)) <= 1e-12L * glm::length(b);
                 return along ? 0 : of_edge(normal, a, b);
             };
             return is_cut(w.question) && gives(w, around(given, above_horizon(given), without_ground));
         }});
    // Nothing is what many sums give that lack an edge, whichever it is.
    add({"last_edge_forgotten",
         "you give the sum without the last edge",
         [](const WrongAnswer& w) { return w.given[0] > 1e-12 && lacks_last_edge(w); },
         {},
         lacks_last_edge});
    const auto term = [&](const std::string& hint, const std::string& words, Term other) {
        add(by_terms(hint, words, other));
    };
    term("no_cosine", "you give the sum of the angles alone",
         [](const Wide&, const Wide& a, const Wide& b) { return angle_between(a, b); });
    term("asin", "you give the sum with angles of less than 90 degrees, where the right ones are more",
         [](const Wide& normal, const Wide& a, const Wide& b) {
             const long double sine = glm::length(cross(b, a)) / (glm::length(a) * glm::length(b));
             return std::asin(std::min(sine, 1.0L)) * slope(normal, a, b);
         });
    const std::string long_ones = "each edge counts by a cross product that is not of length 1";
    term("not_unit", long_ones, [](const Wide& normal, const Wide& a, const Wide& b) {
        return angle_between(a, b) * dot(normal, cross(b, a));
    });
    term("not_unit", long_ones, [](const Wide& normal, const Wide& a, const Wide& b) {
        return angle_between(a, b) * dot(normal, cross(b, a)) / (glm::length(a) * glm::length(b));
    });
    term("sine_for_angle", "each edge counts by the sine of its angle",
         [](const Wide& normal, const Wide& a, const Wide& b) {
             return dot(normal, cross(b, a)) / (glm::length(a) * glm::length(b));
         });
    term("sine_for_angle", "each edge counts by its chord on the ball, and not by its arc",
         [](const Wide& normal, const Wide& a, const Wide& b) {
             return glm::length(glm::normalize(a) - glm::normalize(b)) * slope(normal, a, b);
         });
    term("sine_above_cosine", "each edge counts by what is missing from its angle to 90 degrees",
         [](const Wide& normal, const Wide& a, const Wide& b) {
             return (std::numbers::pi_v<long double> / 2 - angle_between(a, b)) * slope(normal, a, b);
         });
    const std::string one_sign = "edges that should count with a minus count with a plus, or not at all";
    term("edge_signs", one_sign,
         [](const Wide& normal, const Wide& a, const Wide& b) { return std::abs(of_edge(normal, a, b)); });
    term("edge_signs", one_sign,
         [](const Wide& normal, const Wide& a, const Wide& b) { return std::max(0.0L, of_edge(normal, a, b)); });
    const std::string origin = "you give what the origin sees, and not the point";
    add(instead("point_forgotten", origin, [](const Arguments& given) {
        return truth({{0, 0, 0}, given.normal, given.polygon});
    }));
    add(instead("point_forgotten", origin, [](const Arguments& given) {
        auto vertices = above_horizon(given);
        for (Wide& vertex : vertices) vertex += Wide(given.point);
        return around(given, vertices, of_edge);
    }));
    const std::string some = "you give what a triangle of the first three vertices would get, or a polygon of four";
    add(instead("three_vertices", some, [](const Arguments& given) { return of_the_first(given, 3); }));
    add(instead("three_vertices", some, [](const Arguments& given) { return of_the_first(given, 4); }));
    for (const double whole : {2.0, 1.0, 4.0})
        add(by_value("solid_angle", "you give the solid angle, as a share of all directions or of those of a half ball",
                     [whole](const Arguments& given) { return solid_angle(given) / (whole * std::numbers::pi); }));
    add(instead("solid_angle", "you give the solid angle", solid_angle));
    add(instead("from_the_middle", "you give what a small patch in the polygon's middle would get", of_the_middle));
    const auto is_cut_and_lit = [](const Case& q) { return is_cut(q) && truth(of(q)) > 0; };
    add({"cut", "the horizon cuts the polygon, and all others are right",
         [](const WrongAnswer& w) { return is_cut(w.question); }, is_cut_and_lit});
    return of_numbers(std::move(all), {"acos"});
}

}  // namespace raylab::grading::contour
