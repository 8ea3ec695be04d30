#pragma once

#include "raylab/geometry/predicate/quadric_intersection.h"

#include <cstddef>

// Shapes that lie in a plane. A ray in the plane misses them.

namespace raylab {

/// The sign of a mirrored placement's determinant: a ray carried by the adjugate is turned round by it.
template <Scalar T>
Sign handedness(const TransformedRay<T>& ray, Signs<T>& signs) {
    return ray.scaled ? signs.of(ray.scale) : Sign::positive;
}

/// The t at which the ray passes through the plane `normal . (P - point) = 0`; `point` and the ray in local
/// coordinates.
template <Scalar T>
std::optional<Root<T>> intersect_plane(const TransformedRay<T>& ray, const Vec3<T>& point, const Vec3<T>& normal,
                                       Sides sides, Signs<T>& signs) {
    const T speed = dot(normal, ray.direction);
    const Sign along_normal = signs.of(speed);
    if (along_normal == Sign::zero) return std::nullopt;
    if (sides != Sides::both && !sees(sides, along_normal * handedness(ray, signs))) return std::nullopt;
    const Root<T> t = ratio(dot(normal, point - ray.origin), speed);
    return is_within(t, ray.range, signs) ? std::optional(t) : std::nullopt;
}

template <Scalar T>
std::optional<Intersection<T>> intersect(const TransformedRay<T>& ray, const Plane& plane, Sides sides,
                                         Signs<T>& signs) {
    const auto t = intersect_plane(ray, ray.point(plane.point), convert<T>(plane.normal), sides, signs);
    return t ? std::optional(Intersection<T>{*t}) : std::nullopt;
}

/// The point at t = -b/a relative to `from`, multiplied by a.
template <Scalar T>
Vec3<T> point_at(const TransformedRay<T>& ray, const Root<T>& t, const Vec3<T>& from) {
    return t.a * (ray.origin - from) - t.b * ray.direction;
}

template <Scalar T>
std::optional<Intersection<T>> intersect(const TransformedRay<T>& ray, const Disk& disk, Sides sides, Signs<T>& signs) {
    const Vec3<T> center = ray.point(disk.center);
    const auto t = intersect_plane(ray, center, convert<T>(disk.normal), sides, signs);
    if (!t) return std::nullopt;
    const Vec3<T> spoke = point_at(ray, *t, center);
    const T radius = ray.length(disk.radius) * t->a;
    if (signs.of(radius * radius - dot(spoke, spoke)) == Sign::negative) return std::nullopt;
    return Intersection<T>{*t};
}

template <Scalar T>
std::optional<Intersection<T>> intersect(const TransformedRay<T>& ray, const Annulus& annulus, Sides sides,
                                         Signs<T>& signs) {
    const Vec3<T> center = ray.point(annulus.center);
    const auto t = intersect_plane(ray, center, convert<T>(annulus.normal), sides, signs);
    if (!t) return std::nullopt;
    const Vec3<T> spoke = point_at(ray, *t, center);
    const T distance_squared = dot(spoke, spoke);
    const T inner = ray.length(annulus.inner_radius) * t->a, outer = ray.length(annulus.outer_radius) * t->a;
    if (signs.of(outer * outer - distance_squared) == Sign::negative) return std::nullopt;
    if (signs.of(distance_squared - inner * inner) == Sign::negative) return std::nullopt;
    return Intersection<T>{*t};
}

/// The sum of v_i x v_{i+1}, taken from the first vertex, where it is shorter to write down and just as large.
template <Scalar T>
Vec3<T> newell_normal(const Polygon& polygon) {
    const auto& v = polygon.vertices;
    const Vec3<T> first = convert<T>(v.front());
    Vec3<T> sum{T(0.0), T(0.0), T(0.0)};
    for (std::size_t i = 1; i + 1 < v.size(); ++i) {
        sum = sum + cross(convert<T>(v[i]) - first, convert<T>(v[i + 1]) - first);
    }
    return sum;
}

enum class Axis { x, y, z };

/// x before y before z where equal.
template <Scalar T>
Axis dominant_axis(const Vec3<T>& v, Signs<T>& signs) {
    const auto larger = [&](const T& a, const T& b) { return signs.of((a - b) * (a + b)) == Sign::positive; };
    if (larger(v.y, v.x)) return larger(v.z, v.y) ? Axis::z : Axis::y;
    return larger(v.z, v.x) ? Axis::z : Axis::x;
}

/// Two coordinates of a vertex, seen from the point that is asked about.
template <Scalar T>
struct Seen {
    T x, y;
};

template <Scalar T>
Seen<T> seen_along(Axis axis, const Vec3<T>& v) {
    if (axis == Axis::x) return {v.y, v.z};
    return axis == Axis::y ? Seen<T>{v.z, v.x} : Seen<T>{v.x, v.y};
}

enum class EdgeCrossing { nothing, half_axis, origin };

/// The relation of the edge from p to q to the half axis x > 0, y = 0, its lower end counted as the edge's and its
/// upper end not.
template <Scalar T>
EdgeCrossing edge_crossing(const Seen<T>& p, const Seen<T>& q, Signs<T>& signs) {
    const Sign below = signs.of(p.y), above = signs.of(q.y);
    if (below == Sign::zero && above == Sign::zero) {
        return signs.of(p.x) * signs.of(q.x) == Sign::positive ? EdgeCrossing::nothing : EdgeCrossing::origin;
    }
    if (below == Sign::zero && signs.of(p.x) == Sign::zero) return EdgeCrossing::origin;
    if ((below == Sign::positive) == (above == Sign::positive)) return EdgeCrossing::nothing;
    const Sign turn = signs.of(p.x * q.y - p.y * q.x);
    if (turn == Sign::zero) return EdgeCrossing::origin;
    return (turn == Sign::positive) == (above == Sign::positive) ? EdgeCrossing::half_axis : EdgeCrossing::nothing;
}

template <Scalar T>
std::optional<Intersection<T>> intersect(const TransformedRay<T>& ray, const Polygon& polygon, Sides sides,
                                         Signs<T>& signs) {
    const auto& vertices = polygon.vertices;
    const Vec3<T> normal = newell_normal<T>(polygon);
    const auto t = intersect_plane(ray, ray.point(vertices.front()), normal, sides, signs);
    if (!t) return std::nullopt;

    const Axis axis = dominant_axis(normal, signs);
    // Stretched, perhaps by a negative factor: neither matters to inside and outside.
    const auto seen = [&](const Vec3f& vertex) { return seen_along<T>(axis, point_at(ray, *t, ray.point(vertex))); };
    bool inside = false;
    Seen<T> p = seen(vertices.back());
    for (const Vec3f& vertex : vertices) {
        const Seen<T> q = seen(vertex);
        const EdgeCrossing hit_found = edge_crossing(p, q, signs);
        if (hit_found == EdgeCrossing::origin) return Intersection<T>{*t};
        if (hit_found == EdgeCrossing::half_axis) inside = !inside;
        p = q;
    }
    return inside ? std::optional(Intersection<T>{*t}) : std::nullopt;
}

}  // namespace raylab
