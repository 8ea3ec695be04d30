#pragma once

#include "raylab/geometry/part.h"
#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/shapes.h"
#include "raylab/geometry/transformed_ray.h"
#include "raylab/number/root.h"

#include <concepts>
#include <optional>

namespace raylab {

/// F(t) = a t^2 + 2 b t + c, negative inside a surface and positive outside; discriminant = b^2 - a c.
template <Scalar T>
struct AlongRay {
    T a, b, c, discriminant;
};

/// The smallest t with F(t) = 0 that `accepts(t, sign of F'(t))`. F = 0 everywhere (a line lying in the surface) has
/// none.
template <Scalar T, class Accepts>
std::optional<Root<T>> first_zero(const AlongRay<T>& f, Signs<T>& signs, const Accepts& accepts) {
    const Sign of_a = signs.of(f.a);
    if (of_a == Sign::zero) {
        const Sign of_b = signs.of(f.b);
        if (of_b == Sign::zero) return std::nullopt;
        const Root<T> root = ratio(-f.c, f.b + f.b);
        return accepts(root, of_b) ? std::optional(root) : std::nullopt;
    }
    const Sign crossing = signs.of(f.discriminant);
    if (crossing == Sign::negative) return std::nullopt;
    for (const Sign branch : {-of_a, of_a}) {
        const Root<T> root{f.a, f.b, f.c, f.discriminant, branch};
        if (accepts(root, branch * crossing)) return root;  // F'(t) = 2 (a t + b) = 2 branch sqrt(discriminant)
    }
    return std::nullopt;
}

/// The nearest hit a predicate has found: its t, and which part of the shape it is on.
template <Scalar T>
struct Intersection {
    Root<T> t;
    Part part = Part::side;
};

/// |f + t d|^2 - r^2: a sphere about the origin.
template <Scalar T>
AlongRay<T> about_origin(const Vec3<T>& f, const Vec3<T>& d, const T& r) {
    const Vec3<T> moment = cross(d, f);
    const T a = dot(d, d);
    // b^2 - a c = a r^2 - |d x f|^2 by Lagrange's identity, without the cancellation of the left side
    return {a, dot(d, f), dot(f, f) - r * r, a * (r * r) - dot(moment, moment)};
}

template <Scalar T>
AlongRay<T> along(const TransformedRay<T>& ray, const Sphere& sphere) {
    return about_origin<T>(ray.origin - ray.point(sphere.center), ray.direction, ray.length(sphere.radius));
}

/// Coordinate by coordinate multiplied by the product of the other two radii, an ellipsoid is a sphere whose radius is
/// the product of all three.
template <Scalar T>
Vec3<T> products_of_others(const Vec3<T>& radii) {
    return {radii.y * radii.z, radii.z * radii.x, radii.x * radii.y};
}

/// The ray begins at f, as seen from the ellipsoid's center.
template <Scalar T>
AlongRay<T> about_center(const Vec3<T>& f, const Vec3<T>& d, const Vec3<T>& radii) {
    const Vec3<T> others = products_of_others<T>(radii);
    const auto stretched = [&](const Vec3<T>& v) { return Vec3<T>{v.x * others.x, v.y * others.y, v.z * others.z}; };
    return about_origin<T>(stretched(f), stretched(d), radii.x * others.x);
}

template <Scalar T>
AlongRay<T> along(const TransformedRay<T>& ray, const Ellipsoid& ellipsoid) {
    return about_center<T>(ray.origin - ray.point(ellipsoid.center), ray.direction, ray.point(ellipsoid.radii));
}

template <Scalar T, class Closed>
    requires std::same_as<Closed, Sphere> || std::same_as<Closed, Ellipsoid>
std::optional<Intersection<T>> intersect(const TransformedRay<T>& ray, const Closed& shape, Sides sides,
                                         Signs<T>& signs) {
    const auto t = first_zero(along(ray, shape), signs, [&](const Root<T>& root, Sign outward) {
        return sees(sides, outward) && is_within(root, ray.range, signs);
    });
    return t ? std::optional(Intersection<T>{*t}) : std::nullopt;
}

}  // namespace raylab
