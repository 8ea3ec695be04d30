#include "raylab/accelerator/light_buffer/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace raylab {

namespace {

// A dot product of three terms is off by less than 3 u |n| |p|, and by three underflows, which are nothing beside the
// blur; what is left is for the lengths' own rounding. (Of a pyramid's corners: their length is at most sqrt 3.)
constexpr double dot_error = 8 * unit_roundoff<double>;
constexpr double longest = std::numbers::sqrt3;

}  // namespace

Silhouette::Silhouette(Hull hull) : hull_(std::move(hull)), reach_(hull_.blur + hull_.ball) {
    for (const Vec3d& corner : hull_.corners) largest_ = std::max(largest_, glm::length(corner));
    farthest_ = (largest_ + reach_) * (1 + dot_error);
    margin_ = reach_ + dot_error * (largest_ + reach_);
    find_nearest();
    if (hull_.face_normals.size() == 1) {
        normal_ = glm::normalize(hull_.face_normals[0]);
        if (dot(normal_, hull_.corners[0]) < 0) normal_ = -normal_;
        height_ = smallest(normal_);
    }
    if (is_ball()) {
        const double distance = glm::length(hull_.corners[0]);
        way_ = hull_.corners[0] / distance;
        sine_ = std::min(1.0, reach_ / distance) * (1 + 2 * dot_error);
        cosine_ = std::sqrt(std::max(0.0, 1 - sine_ * sine_));
    }
    find_halves();
    if (hull_.covers == Hull::Covers::perhaps && !is_ball()) find_cover();
}

// A lower bound of n . x for all points x of the blurred shape; `length` is |n| or more.
double Silhouette::smallest(const Vec3d& normal, double length) const {
    double low = std::numeric_limits<double>::infinity();
    for (const Vec3d& corner : hull_.corners) low = std::min(low, dot(normal, corner));
    return low - length * margin_;
}

// All of the shape is on the far side of a plane at right angles to the way to its nearest point; that point is a
// corner, on an edge, or in a face.
void Silhouette::find_nearest() {
    const auto consider = [&](const Vec3d& way) {
        const double length = glm::length(way) * (1 + dot_error);
        if (length > 0) nearest_ = std::max(nearest_, smallest(way) / length);
    };
    for (const Vec3d& corner : hull_.corners) consider(corner);
    for (const auto& [from, to] : hull_.edges) {
        const Vec3d a = hull_.corners[from], along = hull_.corners[to] - a;
        consider(a - along * (dot(a, along) / dot(along, along)));
    }
    for (const Vec3d& normal : hull_.face_normals) {
        consider(normal);
        consider(-normal);
    }
}

// If n . x >= m for all points x of the shape, then n . x / |x| >= m / |x| for each: and their distances are known. A
// direction c with n . c / |c| below that is none of theirs. 1 <= |c| <= sqrt 3.
Silhouette::Half Silhouette::half(const Vec3d& normal) const {
    const double low = smallest(normal);
    const double slope = low >= 0 ? low / farthest_ : low / nearest_ * longest;  // nearest_ = 0: -infinity, never below
    return {normal, slope - std::abs(slope) * dot_error - dot_error * longest * glm::length(normal)};
}

void Silhouette::find_halves() {
    for (const auto& [from, to] : hull_.edges) {
        const Vec3d normal = cross(hull_.corners[from], hull_.corners[to]);
        for (const Vec3d& n : {normal, -normal}) {
            const Half found = half(n);
            if (found.bound > -glm::length(n)) outside_.push_back(found);  // others keep nothing out
        }
    }
}

// The shape's cone is what is inside the planes through its edges, where each of them has all corners on one side. What
// strays by the blur must still be inside, and an edge's plane is known only as well as its two corners are. Which side
// of it is inside tells a corner that surely is not in the plane: a triangle without area, or whose area is lost in
// roundings, has none, and covers nothing.
void Silhouette::find_cover() {
    if (!(nearest_ > 2 * hull_.blur)) return;
    for (const auto& [from, to] : hull_.edges) {
        const Vec3d a = hull_.corners[from], b = hull_.corners[to];
        Vec3d normal = cross(a, b);
        if (dot(normal, hull_.corners[(to + 1) % hull_.corners.size()]) < 0) normal = -normal;
        const double error = 2 * dot_error * glm::length(a) * glm::length(b);
        double farthest_inside = 0;
        for (const Vec3d& corner : hull_.corners) {
            const double inside = dot(normal, corner);
            if (!(inside >= -error * largest_)) return inside_.clear();
            farthest_inside = std::max(farthest_inside, inside);
        }
        const double lost_in_blur = 4 * hull_.blur * largest_ * largest_;  // of a determinant of three corners
        if (!(farthest_inside > error * largest_ + lost_in_blur)) return inside_.clear();
        inside_.push_back({normal, longest * (2 * hull_.blur / nearest_ * glm::length(normal) + error +
                                              dot_error * glm::length(normal))});
    }
}

// A plane that touches a ball on the side that is turned to the pyramid.
Silhouette::Half Silhouette::tangent(const LightPyramid& pyramid) const {
    const Vec3d other = pyramid.center(), aside = dot(other, way_) * way_ - other;
    return half(way_ * sine_ + aside * (cosine_ / glm::length(aside)));
}

// Tests the pyramid's four sides and the plane behind it: n . p for n = (-1, 0, u_min), ... as outward() has them.
bool Silhouette::is_outside_by_sides(const LightPyramid& pyramid) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const int axis = pyramid.axis(), first = (axis + 1) % 3, second = (axis + 2) % 3;
    const double sign = pyramid.sign();
    double left = infinity, right = infinity, below = infinity, above = infinity, behind = infinity;
    for (const Vec3d& p : hull_.corners) {
        const double u = p[first], v = p[second], w = sign * p[axis];
        left = std::min(left, pyramid.u_min * w - u);
        right = std::min(right, u - pyramid.u_max * w);
        below = std::min(below, pyramid.v_min * w - v);
        above = std::min(above, v - pyramid.v_max * w);
        behind = std::min(behind, -w);
    }
    const auto beyond = [&](double smallest,
                            double slope) {  // of a side's plane, whose normal is sqrt(1 + slope^2) long
        return smallest > margin_ && smallest > margin_ * std::sqrt(1 + slope * slope) * (1 + dot_error);
    };
    return beyond(left, pyramid.u_min) || beyond(right, pyramid.u_max) || beyond(below, pyramid.v_min) ||
           beyond(above, pyramid.v_max) || behind > margin_;
}

bool Silhouette::is_outside_by_edges(const LightPyramid& pyramid) const {
    const auto corners = pyramid.corners();
    const auto keeps_out = [&](const Half& half) {
        return std::ranges::all_of(corners, [&](const Vec3d& c) { return dot(half.normal, c) < half.bound; });
    };
    return is_ball() ? keeps_out(tangent(pyramid)) : std::ranges::any_of(outside_, keeps_out);
}

bool Silhouette::is_outside(const LightPyramid& pyramid) const {
    return is_outside_by_sides(pyramid) || is_outside_by_edges(pyramid);
}

// A point at depth w in direction c (whose depth is 1) is w c. In the plane of what is flat, n . (w c) lies between two
// numbers, and n . c is greatest, and least, at a corner of the pyramid.
double Silhouette::min_depth(const LightPyramid& pyramid) const {
    const double depth = std::max(0.0, smallest(pyramid.vector(0, 0, 1), 1));
    if (!(height_ > 0)) return depth;
    double steepest = 0;
    for (const Vec3d& c : pyramid.corners()) steepest = std::max(steepest, dot(normal_, c));
    steepest += 2 * dot_error * longest;
    return std::max(depth, height_ / steepest * (1 - dot_error));
}

std::optional<double> Silhouette::cover_depth(const LightPyramid& pyramid) const {
    if (hull_.covers == Hull::Covers::never) return std::nullopt;
    return is_ball() ? cover_depth_of_ball(pyramid) : cover_depth_of_flat(pyramid);
}

std::optional<double> Silhouette::cover_depth_of_flat(const LightPyramid& pyramid) const {
    // The plane passes the light so far that a way which ends before the light has crossed it.
    if (inside_.empty() || !(height_ > 2 * hull_.blur)) return std::nullopt;
    double flattest = std::numeric_limits<double>::infinity();
    for (const Vec3d& c : pyramid.corners()) {
        for (const Half& half : inside_)
            if (!(dot(half.normal, c) > half.bound)) return std::nullopt;
        flattest = std::min(flattest, dot(normal_, c));
    }
    flattest -= 2 * dot_error * longest;
    const double deepest = greatest(pyramid.vector(0, 0, 1));
    return flattest > 0 ? std::min(deepest, greatest(normal_) / flattest * (1 + dot_error)) : deepest;
}

// A way that passes the centre at distance q enters the ball sqrt(d^2 - q^2) - sqrt(r^2 - q^2) from the light, the
// later the larger q is; in the pyramid it is largest along a corner. The depth is no more than the distance.
std::optional<double> Silhouette::cover_depth_of_ball(const LightPyramid& pyramid) const {
    const Vec3d center = hull_.corners[0];
    const double distance = glm::length(center), radius = hull_.ball;
    if (!(distance - radius > 4 * hull_.blur)) return std::nullopt;
    double passing = 0;
    for (const Vec3d& c : pyramid.corners()) {
        if (!(dot(center, c) > 0)) return std::nullopt;
        passing = std::max(passing, glm::length(cross(center, c)) / glm::length(c));
    }
    passing += 2 * hull_.blur;
    if (!(passing < radius)) return std::nullopt;
    const auto leg = [&](double longest_side) { return std::sqrt(longest_side * longest_side - passing * passing); };
    return leg(distance) - leg(radius) + 2 * hull_.blur;
}

}  // namespace raylab
