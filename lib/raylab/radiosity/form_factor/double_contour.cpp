#include "raylab/radiosity/form_factor/double_contour.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/form_factor/tanh_sinh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace raylab {

namespace {

struct Edge {
    Vec3d start, direction;  // of length 1
    double length;
};

std::vector<Edge> edges(std::span<const Vec3d> polygon) {
    std::vector<Edge> found;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d way = polygon[(i + 1) % polygon.size()] - polygon[i];
        const double length = glm::length(way);
        if (length > 0) found.push_back({polygon[i], way / length, length});
    }
    return found;
}

// The antiderivative of ln sqrt(x^2 + d^2).
double log_distance_integral(double x, double d) {
    const double squared = x * x + d * d;
    return squared > 0 ? x * (0.5 * std::log(squared) - 1) + d * std::atan2(x, d) : 0;
}

// The integral of ln r along an edge, with r the distance from a point.
double log_distance_along(const Edge& edge, const Vec3d& point) {
    const Vec3d way = edge.start - point;
    const double x = dot(way, edge.direction), d = glm::length(cross(way, edge.direction));
    return log_distance_integral(x + edge.length, d) - log_distance_integral(x, d);
}

// Where on an edge the inner integral over another edge is not smooth, or nearly so: at the feet of the other's ends,
// and where the two lines come nearest.
std::array<double, 5> pieces(const Edge& outer, const Edge& inner) {
    const auto inside = [&](double s) { return std::clamp(s, 0.0, outer.length); };
    const Vec3d way = inner.start - outer.start, across = cross(outer.direction, inner.direction);
    const double squared = dot(across, across);
    const double start = dot(way, outer.direction), end = start + inner.length * dot(inner.direction, outer.direction);
    const double nearest = squared > 0 ? dot(cross(way, inner.direction), across) / squared : 0;
    std::array<double, 5> ends{0, inside(start), inside(end), inside(nearest), outer.length};
    std::ranges::sort(ends);
    return ends;
}

double edge_pair(const Edge& outer, const Edge& inner, double tolerance) {
    const double cosine = dot(outer.direction, inner.direction);
    if (cosine == 0) return 0;
    const auto ends = pieces(outer, inner);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const auto log_distances = [&](double s) {
            return log_distance_along(inner, outer.start + (ends[i] + s) * outer.direction);
        };
        if (ends[i + 1] > ends[i]) sum += tanh_sinh_integral(log_distances, ends[i + 1] - ends[i], tolerance);
    }
    return cosine * sum;
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
    for (const Edge& a : outer)
        for (const Edge& b : inner) sum += edge_pair(a, b, 1e-12 * a.length * b.length);
    return sum * unit * unit / (2 * std::numbers::pi);
}

}  // namespace raylab
