#pragma once

#include "other_cells.h"

#include <array>
#include <vector>

// The cells of a polygon that is cut in another way, which is how a mistake in the cutting is known.

namespace raylab::grading::listing {

using Polygon = std::vector<Seen>;

inline Polygon polygon_of(const Arguments& given) {
    Polygon polygon;
    for (const Vec3d& corner : given.corners) polygon.push_back(seen_by(corner, given.face));
    return polygon;
}

/// One of the pyramid's four sides; the inner side is above.
inline long double above(const Seen& p, int side) { return p.w - (side % 2 == 0 ? 1 : -1) * (side < 2 ? p.u : p.v); }

/// What is done otherwise at each of the sides.
enum class Flaw {
    none,
    open,           // no edge from the last corner to the first
    closes_before,  // the edge to the first corner comes from the last one of the polygon as it was given
    at_half,        // a crossing is halfway between two corners
    by_the_sum,     // a / (a + b), b being negative
    other_share     // the crossing is as far from the one corner as it should be from the other
};

inline long double share_of(long double a, long double b, Flaw flaw) {
    switch (flaw) {
        case Flaw::at_half:
            return 0.5L;
        case Flaw::by_the_sum:
            return a / (a + b);
        case Flaw::other_share:
            return b / (b - a);
        default:
            return a / (a - b);
    }
}

/// `height` says how far above the cut a point is.
template <class Height>
Polygon cut(const Polygon& polygon, const Seen& last_given, const Height& height, Flaw flaw) {
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const bool is_closing = i == 0;
        const Seen& to = polygon[i];
        const Seen& from = !is_closing ? polygon[i - 1] : flaw == Flaw::closes_before ? last_given : polygon.back();
        const long double a = height(from), b = height(to);
        if (a * b < 0 && !(is_closing && flaw == Flaw::open)) left.push_back(between(from, to, share_of(a, b, flaw)));
        if (b >= 0) left.push_back(to);
    }
    return left;
}

/// What is left of a polygon after cuts at these sides, one after another.
template <class Sides>
Polygon cut_at(const Sides& sides, Polygon polygon, Flaw flaw = Flaw::none) {
    if (polygon.empty()) return polygon;
    const Seen last_given = polygon.back();
    for (const int side : sides)
        polygon = cut(
            polygon, last_given, [side](const Seen& p) { return above(p, side); }, flaw);
    return polygon;
}

inline std::optional<CellRectangle> cells_of(const Polygon& polygon, int resolution) {
    Window all;
    for (const auto& [u, v, w] : polygon)
        all = {std::min(all.left, u / w), std::max(all.right, u / w), std::min(all.low, v / w),
               std::max(all.high, v / w)};
    return cells_of(all, resolution);
}

/// Whether a cut polygon has a point level with the light: a wrong cut may leave one, whose image is at no place that
/// two compilers would agree on.
inline bool has_a_point_level_with_the_light(const Polygon& polygon) {
    return std::ranges::any_of(
        polygon, [](const Seen& p) { return std::abs(p.w) < 1e-9L * std::max(std::abs(p.u), std::abs(p.v)); });
}

/// The cells that are seen of what is at least so far from the light, along the face's axis.
inline std::optional<CellRectangle> cells_beyond(const Arguments& given, long double depth) {
    const Polygon all = polygon_of(given);
    const Polygon beyond = cut(
        all, all.back(), [depth](const Seen& p) { return p.w - depth; }, Flaw::none);
    return cells_of(cut_at(std::array{0, 1, 2, 3}, beyond), given.resolution);
}

/// Whether the corners run to the right or to the left around the polygon, as the light sees it.
inline bool runs(const Case& question, double way) {
    const auto corners = of(question).corners;
    return way * dot(cross(corners[1] - corners[0], corners[2] - corners[0]), corners[0]) > 0;
}

inline void add_cuts(std::vector<Symptom>& all) {
    const auto cells_are = [&](const std::string& hint, const std::string& words, const auto& other) {
        all.push_back({hint, words, [other](const WrongAnswer& w) { return said(w) == other(of(w.question)); },
                       [other](const Case& q) { return other(of(q)) != truth(of(q)); }});
    };
    for (const double way : {-1.0, 1.0})
        for (const bool in_coordinates_of_the_face : {false, true}) {  // those of a negative one are a mirror image
            const auto is_back = [=](const Case& q) {
                return runs(q, in_coordinates_of_the_face && is_negative(q) ? -way : way);
            };
            all.push_back({"from_both_sides", "the corners run the one way around, and you list no cell",
                           [is_back](const WrongAnswer& w) { return is_back(w.question) && !said(w); },
                           [is_back](const Case& q) { return is_back(q) && truth(of(q)).has_value(); }});
        }
    for (const long double depth : {1.0L, 0.1L, 0.01L, 0.001L, 1e-4L, 1e-5L, 1e-6L})
        cells_are("near_plane", "what is near the light is missing, as if it were cut off there",
                  [depth](const Arguments& given) { return cells_beyond(given, depth); });
    for (const auto& sides : std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1}, {2, 3}})
        cells_are(
            "four_sides", "the polygon is cut at some of the pyramid's sides only",
            [sides](const Arguments& given) { return cells_of(cut_at(sides, polygon_of(given)), given.resolution); });
    cells_are("thrown_over", "the polygon is cut as if its corners behind the light, or all of it, were before it",
              [](const Arguments& given) {
                  Polygon folded = polygon_of(given);
                  for (Seen& p : folded) p.w = std::abs(p.w);
                  return cells_of(cut_at(std::array{0, 1, 2, 3}, folded), given.resolution);
              });
    const auto in_any_order = [&](const std::string& hint, const std::string& words, Flaw flaw) {
        std::array<int, 4> sides{0, 1, 2, 3};
        do {
            cells_are(hint, words, [sides, flaw](const Arguments& given) {
                return cells_of(cut_at(sides, polygon_of(given), flaw), given.resolution);
            });
            all.back().allows = [sides, flaw](const WrongAnswer& w) {
                return has_a_point_level_with_the_light(cut_at(sides, polygon_of(of(w.question)), flaw));
            };
        } while (std::ranges::next_permutation(sides).found);
    };
    in_any_order("last_edge", "the edge from the last corner to the first is not cut", Flaw::open);
    in_any_order("last_edge",
                 "the closing edge comes from the last corner that was given, not the last one that is left",
                 Flaw::closes_before);
    in_any_order("crossing", "an edge is cut in its middle", Flaw::at_half);
    in_any_order("crossing", "an edge is cut at the share a / (a + b)", Flaw::by_the_sum);
    in_any_order("crossing", "an edge is cut as far from the one end as it should be from the other",
                 Flaw::other_share);
}

}  // namespace raylab::grading::listing
