#pragma once

#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/triangle_hit.h"

#include <cmath>
#include <concepts>
#include <utility>

namespace raylab {

namespace detail {

/// The ray seen along its own dominant axis z: space is sheared so that it becomes the axis itself, through the origin.
template <Real T>
struct Shear {
    int x, y, z;
    T by_x, by_y, scale;

    explicit Shear(const Vec3<T>& direction) : z(dominant_axis(direction)) {
        const auto [first, second] = other_axes(z);
        x = first;
        y = second;
        if (direction[z] < 0) std::swap(x, y);  // keeps the winding
        by_x = direction[x] / direction[z];
        by_y = direction[y] / direction[z];
        scale = T(1) / direction[z];
    }

    Vec3<T> operator()(const Vec3<T>& v) const { return {v[x] - by_x * v[z], v[y] - by_y * v[z], scale * v[z]}; }
};

/// Twice the signed area of (0, p, q) in the plane; exactly antisymmetric in p and q, as long as nothing is fused.
template <class Vector>
auto area(const Vector& p, const Vector& q) {
    return p.x * q.y - p.y * q.x;
}

}  // namespace detail

/// Shear space until the ray is an axis; then three areas in 2D decide, each a function of one edge only.
/// Source: Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013, pp. 65-82.
/// Weak spot: watertight, not exact; a ray at a vertex may hit several triangles. Fused multiply-add breaks it.
template <Real T>
std::optional<TriangleHitOf<T>> watertight(const RayOf<T>& ray, const TriangleOf<T>& triangle) {
    const detail::Shear<T> shear(ray.direction);
    const Vec3<T> a = shear(triangle.a - ray.origin);
    const Vec3<T> b = shear(triangle.b - ray.origin);
    const Vec3<T> c = shear(triangle.c - ray.origin);

    T u = detail::area(c, b), v = detail::area(a, c), w = detail::area(b, a);
    if constexpr (std::same_as<T, float>) {
        // A float zero may hide either sign; in double the products of floats are exact and so is the sign.
        if (u == 0 || v == 0 || w == 0) {
            const Vec3d da = convert<double>(a), db = convert<double>(b), dc = convert<double>(c);
            u = cast<T>(detail::area(dc, db));
            v = cast<T>(detail::area(da, dc));
            w = cast<T>(detail::area(db, da));
        }
    }
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return std::nullopt;

    const T whole = u + v + w;
    if (whole == 0 || !std::isfinite(whole)) return std::nullopt;
    const T t = (u * a.z + v * b.z + w * c.z) / whole;
    if (!contains(ray.range, t)) return std::nullopt;
    return TriangleHitOf<T>{t, v / whole, w / whole};
}

}  // namespace raylab
