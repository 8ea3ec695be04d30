#pragma once

#include "raylab/geometry/triangle_hit.h"

#include <cmath>

namespace raylab {

/// The textbook's two steps: intersect the plane, then ask of each edge whether the point is on its inner side.
/// Source: e.g. Glassner (ed.), An Introduction to Ray Tracing, 1989, chapter 2 (Haines).
/// Weak spot: the point is rounded before it is asked where it lies.
template <Real T>
std::optional<TriangleHitOf<T>> plane_and_edges(const RayOf<T>& ray, const TriangleOf<T>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3<T> normal = cross(b - a, c - a);
    const T t = dot(normal, a - ray.origin) / dot(normal, ray.direction);
    if (!contains(ray.range, t)) return std::nullopt;  // parallel rays too: their t is no number

    const Vec3<T> point = ray.origin + t * ray.direction;
    const T beyond_ab = dot(normal, cross(b - a, point - a));
    const T beyond_bc = dot(normal, cross(c - b, point - b));
    const T beyond_ca = dot(normal, cross(a - c, point - c));
    if (!(beyond_ab >= 0 && beyond_bc >= 0 && beyond_ca >= 0)) return std::nullopt;

    const T whole = beyond_ab + beyond_bc + beyond_ca;
    if (!(whole > 0 && std::isfinite(whole))) return std::nullopt;  // under- or overflow: no number is no hit
    return TriangleHitOf<T>{t, beyond_ca / whole, beyond_ab / whole};
}

}  // namespace raylab
