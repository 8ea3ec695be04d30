#include "raylab/radiosity/form_factor/double_contour.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/form_factor/edge_pair.h"

#include <numbers>

namespace raylab {

namespace {

std::vector<PolygonEdge> edges(std::span<const Vec3d> polygon) {
    std::vector<PolygonEdge> found;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d way = polygon[(i + 1) % polygon.size()] - polygon[i];
        const double length = glm::length(way);
        if (length > 0) found.push_back({polygon[i], way / length, length});
    }
    return found;
}

// Of edges in units of the polygons' size.
double edge_pair(const PolygonEdge& a, const PolygonEdge& b) {
    const double cosine = dot(a.direction, b.direction);
    if (cosine == 0) return 0;
    constexpr double farthest = 4;  // leaves an error of some 1e-15
    return cosine * (edge_pair_reach(a, b) <= farthest ? edge_pair_closed(a, b) : edge_pair_numerical(a, b));
}

}  // namespace

double double_contour(std::span<const Vec3d> from, std::span<const Vec3d> to) {
    // In units of the polygons' size the logarithms are small, and the answer does not depend on the unit of length.
    const PolygonBall ball = polygon_ball(from), other = polygon_ball(to);
    const double unit = ball.radius + other.radius;
    const auto scaled = [&](std::span<const Vec3d> polygon) {
        std::vector<Vec3d> vertices;
        for (const Vec3d& vertex : polygon) vertices.push_back((vertex - ball.center) / unit);
        return vertices;
    };
    const auto outer = edges(scaled(from)), inner = edges(scaled(to));
    double sum = 0;
    for (const PolygonEdge& a : outer)
        for (const PolygonEdge& b : inner) sum += edge_pair(a, b);
    return sum * unit * unit / (2 * std::numbers::pi);
}

}  // namespace raylab
