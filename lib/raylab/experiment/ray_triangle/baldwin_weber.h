#pragma once

#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/triangle_hit.h"

#include <array>

namespace raylab {

/// The affine map that carries a triangle to a = (0,0,0), b = (1,0,0), c = (0,1,0), prepared once. Of its third axis,
/// which is free, one chooses the dominant axis of the normal, so that nine numbers suffice.
/// Source: Baldwin and Weber, Fast Ray-Triangle Intersections by Coordinate Transformation, JCGT 5(3), 2016.
/// Weak spot: the map's own rounding. Its constants are products of world coordinates, as in the paper, so far from the
/// world's origin they drown what they should tell.
template <Real T>
class BaldwinWeber {
public:
    explicit BaldwinWeber(const TriangleOf<T>& triangle) {
        const auto& [a, b, c] = triangle;
        const Vec3<T> ab = b - a, ac = c - a;
        const Vec3<T> normal = cross(ab, ac);
        z_ = dominant_axis(normal);
        const auto [x, y] = other_axes(z_);
        const T length = normal[z_];  // zero for a triangle without area: the rows are no numbers, and all rays miss
        u_ = {ac[y] / length, -ac[x] / length, (c[x] * a[y] - c[y] * a[x]) / length};
        v_ = {-ab[y] / length, ab[x] / length, (b[y] * a[x] - b[x] * a[y]) / length};
        height_ = {normal[x] / length, normal[y] / length, -dot(normal, a) / length};
    }

    friend std::optional<TriangleHitOf<T>> intersect(const RayOf<T>& ray, const BaldwinWeber& map) {
        const int z = map.z_;
        const auto [x, y] = other_axes(z);
        const auto& [o, d, range] = ray;
        const auto& h = map.height_;
        const T t = -(h[0] * o[x] + h[1] * o[y] + o[z] + h[2]) / (h[0] * d[x] + h[1] * d[y] + d[z]);
        if (!contains(range, t)) return std::nullopt;

        const T px = o[x] + t * d[x], py = o[y] + t * d[y];
        const T u = map.u_[0] * px + map.u_[1] * py + map.u_[2];
        const T v = map.v_[0] * px + map.v_[1] * py + map.v_[2];
        if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
        return TriangleHitOf<T>{t, u, v};
    }

private:
    std::array<T, 3> u_, v_, height_;  // coefficients of the two other coordinates, and the constant
    int z_;
};

}  // namespace raylab
