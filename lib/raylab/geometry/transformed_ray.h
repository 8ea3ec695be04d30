#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"

namespace raylab {

/// A ray in the coordinates a shape is given in, all multiplied by `scale`, so that carrying it there needs no
/// division: with x' = A x + b, the point x of a world point x' is adj(A) (x' - b) / det A. Shapes are multiplied by
/// the scale in turn, and t stays what it was.
template <Scalar T>
struct TransformedRay {
    Vec3<T> origin, direction;
    Interval<float> range;
    T scale;
    bool scaled;  // false: scale is one, and multiplying by it would only add rounding

    T length(float x) const { return scaled ? scale * T(x) : T(x); }
    Vec3<T> point(const Vec3f& x) const { return {length(x.x), length(x.y), length(x.z)}; }
};

/// Transforms the ray from a point along a direction of world space, in numbers of any kind.
template <Scalar T>
TransformedRay<T> transformed_ray(const Vec3<T>& origin, const Vec3<T>& direction, const Interval<float>& range,
                                  const Affine& placement) {
    if (placement.is_identity()) return {origin, direction, range, T(1.0), false};

    const auto& c = placement.columns;
    const Vec3<T> x = convert<T>(c[0]), y = convert<T>(c[1]), z = convert<T>(c[2]);
    const Vec3<T> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);  // the rows of the adjugate
    const auto carried = [&](const Vec3<T>& v) { return Vec3<T>{dot(yz, v), dot(zx, v), dot(xy, v)}; };
    return {carried(origin - convert<T>(placement.translation)), carried(direction), range, dot(x, yz), true};
}

template <Scalar T>
TransformedRay<T> transformed_ray(const Ray& ray, const Affine& placement) {
    return transformed_ray<T>(convert<T>(ray.origin), convert<T>(ray.direction), ray.range, placement);
}

}  // namespace raylab
