#pragma once

#include "truth.h"

#include <algorithm>
#include <functional>

// Sums over contours as somebody may have written them: of other vertices, or cut elsewhere.

namespace raylab::grading::contour {

inline long double angle_between(const Wide& a, const Wide& b) {
    return std::atan2(glm::length(cross(b - a, a)), dot(a, b));
}

/// The cosine between the plane of an edge and the ground.
inline long double slope(const Wide& normal, const Wide& a, const Wide& b) {
    const Wide across = cross(b - a, a);
    return glm::length(across) > 0 ? dot(normal, across) / glm::length(across) : 0;
}

using Term = long double (*)(const Wide& normal, const Wide& a, const Wide& b);

inline long double of_edge(const Wide& normal, const Wide& a, const Wide& b) {
    return angle_between(a, b) * slope(normal, a, b);
}

/// The sum over the contour of these vertices, as seen from the point, divided by 2 pi.
inline double around(const Arguments& given, const std::vector<Wide>& vertices, Term term) {
    long double sum = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        sum += term(Wide(given.normal), vertices[i], vertices[(i + 1) % vertices.size()]);
    return static_cast<double>(sum / (2 * std::numbers::pi_v<long double>));
}

inline std::vector<Wide> not_cut(const Arguments& given) {
    std::vector<Wide> vertices;
    for (const Vec3d& vertex : given.polygon) vertices.push_back(Wide(vertex) - Wide(given.point));
    return vertices;
}

inline std::vector<Wide> without_those_below(const Arguments& given) {
    std::vector<Wide> vertices = not_cut(given);
    std::erase_if(vertices, [&](const Wide& v) { return dot(Wide(given.normal), v) < 0; });
    return vertices;
}

inline std::vector<Wide> pushed_up(const Arguments& given) {
    std::vector<Wide> vertices = not_cut(given);
    for (Wide& v : vertices) v -= std::min(0.0L, dot(Wide(given.normal), v)) * Wide(given.normal);
    return vertices;
}

/// The contour whose edges are cut at another share of the way from a to b, by the heights of both.
inline std::vector<Wide> cut_at(const Arguments& given, long double (*share)(long double from, long double to)) {
    const std::vector<Wide> vertices = not_cut(given);
    std::vector<Wide> kept;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Wide &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
        const long double from = dot(Wide(given.normal), a), to = dot(Wide(given.normal), b);
        if (from >= 0) kept.push_back(a);
        if (from * to < 0) kept.push_back(a + (b - a) * share(from, to));
    }
    return kept;
}

/// The contour that is cut where another number than the height over the point's horizon is 0.
inline std::vector<Wide> cut_by(const Arguments& given, const std::function<long double(const Wide&)>& height,
                                bool keep_downward = true, bool keep_upward = true) {
    const std::vector<Wide> vertices = not_cut(given);
    std::vector<Wide> kept;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Wide &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
        const long double from = height(a), to = height(b);
        if (from >= 0) kept.push_back(a);
        if (from * to < 0 && (from > 0 ? keep_downward : keep_upward))
            kept.push_back(a + (b - a) * (from / (from - to)));
    }
    return kept;
}

/// The right contour, but without the crossings at which it goes down through the horizon, or those where it comes up.
inline std::vector<Wide> with_crossings(const Arguments& given, bool downward, bool upward) {
    return cut_by(
        given, [&](const Wide& v) { return dot(Wide(given.normal), v); }, downward, upward);
}

/// Whether all of what is asked is far smaller than a millimetre.
inline bool is_tiny(const Arguments& given) {
    return std::ranges::all_of(given.polygon, [&](const Vec3d& v) { return glm::length(v - given.point) < 1e-3; });
}

/// The sums over some of the edges and not the others.
inline std::vector<double> sums_without_some_edges(const Arguments& given) {
    const auto vertices = above_horizon(given);
    std::vector<long double> sums{0};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const long double edge = of_edge(Wide(given.normal), vertices[i], vertices[(i + 1) % vertices.size()]);
        for (std::size_t k = sums.size(); k-- > 0;) sums.push_back(sums[k] + edge);
    }
    std::vector<double> shares;
    for (const long double sum : sums)
        shares.push_back(std::max(0.0, static_cast<double>(sum / (2 * std::numbers::pi_v<long double>))));
    return shares;
}

inline double of_the_first(Arguments given, std::size_t vertices) {
    given.polygon.resize(std::min(vertices, given.polygon.size()));
    return truth(given);
}

/// The share of all directions around the point, times 4 pi, that a polygon above the horizon covers: the angle of each
/// triangle of a fan (Van Oosterom and Strackee, "The Solid Angle of a Plane Triangle", 1983).
inline double solid_angle(const Arguments& given) {
    const std::vector<Wide> seen = above_horizon(given);
    long double sum = 0;
    for (std::size_t i = 2; i < seen.size(); ++i) {
        const Wide a = glm::normalize(seen[0]), b = glm::normalize(seen[i - 1]), c = glm::normalize(seen[i]);
        sum += 2 * std::atan2(dot(a, cross(c, b)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
    }
    return static_cast<double>(sum);
}

/// Of a small patch in the middle of the polygon, as large as the polygon: A cos cos / (pi r^2).
inline double of_the_middle(const Arguments& given) {
    Vec3d middle{0, 0, 0}, area{0, 0, 0};
    for (const Vec3d& vertex : given.polygon) middle += vertex / static_cast<double>(given.polygon.size());
    for (std::size_t i = 2; i < given.polygon.size(); ++i)
        area += cross(given.polygon[i - 1] - given.polygon[0], given.polygon[i] - given.polygon[0]) / 2.0;
    const Vec3d way = middle - given.point;
    const double squared = dot(way, way);
    return dot(given.normal, way) * -dot(area, way) / (std::numbers::pi * squared * squared);
}

}  // namespace raylab::grading::contour
