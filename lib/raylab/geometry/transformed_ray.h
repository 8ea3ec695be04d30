#pragma once

#include "raylab/geometry/placement_at.h"
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

/// Carries the ray back by the adjugate of a placement's linear part, given by its columns. `origin` is as seen from
/// where the placement moves the shape's own.
template <Scalar T>
TransformedRay<T> carried_back(const Vec3<T>& origin, const Vec3<T>& direction, const Interval<float>& range,
                               const Vec3<T>& x, const Vec3<T>& y, const Vec3<T>& z) {
    const Vec3<T> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);  // the rows of the adjugate
    const auto carried = [&](const Vec3<T>& v) { return Vec3<T>{dot(yz, v), dot(zx, v), dot(xy, v)}; };
    return {carried(origin), carried(direction), range, dot(x, yz), true};
}

/// Transforms the ray from a point along a direction of world space, in numbers of any kind.
template <Scalar T>
TransformedRay<T> transformed_ray(const Vec3<T>& origin, const Vec3<T>& direction, const Interval<float>& range,
                                  const Affine& placement) {
    if (placement.is_identity()) return {origin, direction, range, T(1.0), false};
    const auto& c = placement.columns;
    return carried_back<T>(origin - convert<T>(placement.translation), direction, range, convert<T>(c[0]),
                           convert<T>(c[1]), convert<T>(c[2]));
}

template <Scalar T>
TransformedRay<T> transformed_ray(const Ray& ray, const Affine& placement) {
    return transformed_ray<T>(convert<T>(ray.origin), convert<T>(ray.direction), ray.range, placement);
}

/// The same for a shape that stands at its place at the ray's time.
template <Scalar T>
TransformedRay<T> transformed_ray(const Ray& ray, const Affine& placement, const Motion& motion) {
    const PlacementAt<T> at = placement_at<T>(placement, motion, ray.time);
    const Vec3<T> origin = convert<T>(ray.origin), direction = convert<T>(ray.direction);
    if (only_translates(placement, motion)) return {origin - at.translation, direction, ray.range, T(1.0), false};
    const auto& [x, y, z] = at.columns;
    return carried_back<T>(origin - at.translation, direction, ray.range, x, y, z);
}

}  // namespace raylab
