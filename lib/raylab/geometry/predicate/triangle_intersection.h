#pragma once

#include "raylab/geometry/predicate/flat_intersection.h"

#include <optional>

namespace raylab {

/// The crossing of a ray and a triangle: t = volume / (u + v + w), at the point with weights u, v, w of a, b, c.
template <Scalar T>
struct Crossing {
    T u, v, w, volume;

    T determinant() const { return u + v + w; }
    Root<T> t() const { return ratio(volume, determinant()); }
};

/// The crossing inside the range, for a triangle given relative to the ray's origin. The weights are the volumes the
/// direction spans with each edge; they have one sign where the line passes through the triangle, and are all zero
/// where it lies in its plane (a miss).
template <Scalar T>
std::optional<Crossing<T>> crossing(const Vec3<T>& direction, const TriangleOf<T>& triangle,
                                    const Interval<float>& range, Signs<T>& signs) {
    const auto& [a, b, c] = triangle;
    const Vec3<T> bc = cross(b, c);
    const Crossing<T> found{dot(direction, bc), dot(direction, cross(c, a)), dot(direction, cross(a, b)), dot(a, bc)};
    const Sign u = signs.of(found.u), v = signs.of(found.v), w = signs.of(found.w);
    const auto any = [&](Sign sign) { return u == sign || v == sign || w == sign; };
    if (any(Sign::positive) == any(Sign::negative)) return std::nullopt;
    if (!is_within(found.t(), range, signs)) return std::nullopt;
    return found;
}

/// The crossing as seen in the triangle's own coordinates.
template <Scalar T>
std::optional<Crossing<T>> crossing(const TransformedRay<T>& ray, const Triangle& triangle, Sides sides,
                                    Signs<T>& signs) {
    const auto relative = [&](const Vec3f& vertex) { return Vec3<T>(ray.point(vertex) - ray.origin); };
    const auto found = crossing<T>(ray.direction, {relative(triangle.a), relative(triangle.b), relative(triangle.c)},
                                   ray.range, signs);
    if (!found || sides == Sides::both) return found;
    return sees(sides, signs.of(found->determinant()) * handedness(ray, signs)) ? found : std::nullopt;
}

template <Scalar T>
std::optional<Intersection<T>> intersect(const TransformedRay<T>& ray, const Triangle& triangle, Sides sides,
                                         Signs<T>& signs) {
    const auto found = crossing(ray, triangle, sides, signs);
    return found ? std::optional(Intersection<T>{found->t()}) : std::nullopt;
}

}  // namespace raylab
