#include "raylab/radiosity/form_factor/polygon_form_factor.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/form_factor/double_contour.h"
#include "raylab/radiosity/form_factor/form_factor_density.h"
#include "raylab/radiosity/form_factor/polygon_points.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

using Vertices = std::vector<Vec3d>;

// At this distance, in radii of a polygon's ball, eight Gauss points a side give all digits of a double, as soon as the
// double contour integral; nearer, the latter loses at most two digits.
constexpr double far = 8;

// Up to this ratio of radii the terms of the double contour integral are of comparable size.
constexpr double comparable = 4;

// Gauss points a side that leave an error of (2 ratio)^(-2 n) < 1e-17.
int points_per_side(double ratio) { return std::clamp(static_cast<int>(std::ceil(19.6 / std::log(2 * ratio))), 2, 10); }

// The sum over Gauss points of both: the density is smooth.
double between_points(const Vertices& from, const Vertices& to, int from_side, int to_side) {
    const Vec3d normal = polygon_normal(from), normal_to = polygon_normal(to);
    const auto receivers = gauss_points(to, to_side);
    double sum = 0;
    for (const PolygonPoint& p : gauss_points(from, from_side))
        for (const PolygonPoint& q : receivers)
            sum += p.area * q.area * form_factor_density(p.position, normal, q.position, normal_to);
    return sum;
}

// The sum over Gauss points of the smaller polygon, which sees the larger one exactly.
double from_points(const Vertices& from, const Vertices& to, int per_side) {
    const Vec3d normal = polygon_normal(from);
    double sum = 0;
    for (const PolygonPoint& p : gauss_points(from, per_side))
        sum += p.area * contour_form_factor(p.position, normal, to);
    return sum;
}

// The plane through the ball's centre that halves the longest extent.
PatchPlane halving_plane(const Vertices& polygon) {
    const Vec3d center = polygon_ball(polygon).center;
    const Vec3d longest = *std::ranges::max_element(
        polygon, {}, [&](const Vec3d& vertex) { return dot(vertex - center, vertex - center); });
    return {center, glm::normalize(longest - center)};
}

// Of two polygons of which each is in front of the other's plane; `small` has the smaller ball.
double ordered_exchange(const Vertices& small, const Vertices& large) {
    const PolygonBall ball = polygon_ball(small), other = polygon_ball(large);
    if (ball.radius > other.radius) return ordered_exchange(large, small);

    const double apart = glm::length(ball.center - other.center);
    const double small_ratio = distance_to_polygon(ball.center, large) / ball.radius;
    const double large_ratio = (apart - ball.radius) / other.radius;
    if (large_ratio >= far)
        return between_points(small, large, points_per_side(small_ratio), points_per_side(large_ratio));
    if (small_ratio >= far) return from_points(small, large, points_per_side(small_ratio));
    if (other.radius <= comparable * ball.radius) return double_contour(small, large);

    const PatchPlane plane = halving_plane(large);
    double sum = 0;
    for (const PatchPlane& side : {plane, plane.turned()})
        sum += ordered_exchange(small, clipped_to_front(large, side, 0));
    return sum;
}

}  // namespace

double exchange_area(std::span<const Vec3d> from, std::span<const Vec3d> to) {
    const double tolerance = std::max(rounding_height(from), rounding_height(to));
    const auto sender = clipped_to_front(from, patch_plane(to), tolerance);
    const auto receiver = clipped_to_front(to, patch_plane(from), tolerance);
    if (sender.empty() || receiver.empty()) return 0;
    return std::max(0.0, ordered_exchange(sender, receiver));  // seen edge-on, zero may come out as -1e-17
}

double polygon_form_factor(std::span<const Vec3d> from, std::span<const Vec3d> to) {
    return exchange_area(from, to) / polygon_area(from);
}

}  // namespace raylab
