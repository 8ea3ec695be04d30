#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <optional>

namespace raylab {

/// The hit of a triangle: at origin + t direction, which is (1 - u - v) a + u b + v c.
template <Real T>
struct TriangleHitOf {
    T t, u, v;

    friend bool operator==(const TriangleHitOf&, const TriangleHitOf&) = default;
};
using TriangleHit = TriangleHitOf<double>;

/// The hit inside ray.range, if there is one: the triangle is closed (edges and vertices belong to it) and seen from
/// both sides; a ray in its plane misses. This is the slot of exercise 03.
std::optional<TriangleHit> triangle_hit(const RayOf<double>& ray, const TriangleOf<double>& triangle);

}  // namespace raylab
