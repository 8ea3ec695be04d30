#pragma once

#include "raylab/geometry/predicate/quadric_intersection.h"

#include <array>
#include <span>

// Surfaces of revolution (their frame: shapes.h). With g = top - base, p = P - base and L = g.g, the place along the
// axis is sigma = p.g = L s, and the distance from it |p x g|^2 = L rho^2: both without division or root.

namespace raylab {

/// A ray seen from an axis.
template <Scalar T>
struct AxisView {
    T squared_length;             // L
    T place, speed;               // sigma = place + speed t
    Vec3<T> moment, moment_rate;  // p x g = moment + moment_rate t

    /// |p x g|^2 as a quadratic of t; its discriminant is left to the surface.
    AlongRay<T> squared_moment() const {
        return {dot(moment_rate, moment_rate), dot(moment, moment_rate), dot(moment, moment), T(0.0)};
    }
};

/// ... that begins at p, as seen from the base, along the axis g.
template <Scalar T>
AxisView<T> view(const Vec3<T>& p, const Vec3<T>& direction, const Vec3<T>& g) {
    return {dot(g, g), dot(p, g), dot(direction, g), cross(p, g), cross(direction, g)};
}

template <Scalar T>
AxisView<T> view(const TransformedRay<T>& ray, const Vec3f& base, const Vec3f& top) {
    return view<T>(ray.origin - ray.point(base), ray.direction, ray.point(top) - ray.point(base));
}

/// L rho^2 - L radius^2
template <Scalar T>
AlongRay<T> along(const TransformedRay<T>& ray, const Cylinder& cylinder, const AxisView<T>& view) {
    const T radius = ray.length(cylinder.radius);
    const T squared_radius = radius * radius * view.squared_length;
    AlongRay<T> f = view.squared_moment();
    const Vec3<T> turn = cross(view.moment, view.moment_rate);
    f.discriminant = f.a * squared_radius - dot(turn, turn);  // Lagrange's identity, as for the sphere
    f.c = f.c - squared_radius;
    return f;
}

/// L (L rho^2) - (L radius)^2, where L times the radius at sigma is base_radius L + (top_radius - base_radius) sigma.
template <Scalar T>
AlongRay<T> along(const TransformedRay<T>& ray, const Cone& cone, const AxisView<T>& view) {
    const T base = ray.length(cone.base_radius), growth = ray.length(cone.top_radius) - base;
    const T radius = base * view.squared_length + growth * view.place, rate = growth * view.speed;
    const AlongRay<T> m = view.squared_moment();
    const T& length = view.squared_length;
    // b^2 - a c of a sum of signed squares is the signed sum of the squares of their pairs' determinants (Lagrange
    // again).
    const Vec3<T> turn = cross(view.moment, view.moment_rate);
    const Vec3<T> slide = rate * view.moment - radius * view.moment_rate;
    return {length * m.a - rate * rate, length * m.b - radius * rate, length * m.c - radius * radius,
            length * (dot(slide, slide) - length * dot(turn, turn))};
}

/// L rho^2 - radius^2 sigma
template <Scalar T>
AlongRay<T> along(const TransformedRay<T>& ray, const Paraboloid& paraboloid, const AxisView<T>& view) {
    const T radius = ray.length(paraboloid.radius), squared_radius = radius * radius;
    AlongRay<T> f = view.squared_moment();
    // f.b counts half of the linear coefficient: everything twice, so that nothing is halved
    f = {f.a + f.a, f.b + f.b - squared_radius * view.speed, f.c + f.c - (squared_radius + squared_radius) * view.place,
         T(0.0)};
    f.discriminant = f.b * f.b - f.a * f.c;
    return f;
}

/// L (L rho^2) - (waist L)^2 - (radius^2 - waist^2) (2 sigma - L)^2
template <Scalar T>
AlongRay<T> along(const TransformedRay<T>& ray, const Hyperboloid& hyperboloid, const AxisView<T>& view) {
    const T waist = ray.length(hyperboloid.waist), radius = ray.length(hyperboloid.radius);
    const T& length = view.squared_length;
    const T opening = (radius - waist) * (radius + waist), narrow = waist * length;
    const T middle = view.place + view.place - length, rate = view.speed + view.speed;
    const AlongRay<T> m = view.squared_moment();
    AlongRay<T> f{length * m.a - opening * (rate * rate), length * m.b - opening * (middle * rate),
                  length * m.c - (narrow * narrow + opening * (middle * middle)), T(0.0)};
    f.discriminant = f.b * f.b - f.a * f.c;
    return f;
}

/// A disk that closes a surface of revolution where sigma has reached `level`.
struct Cap {
    Part part;
    float radius;
};

struct Caps {
    std::array<Cap, 2> caps;
    std::size_t count;
    auto begin() const { return caps.begin(); }
    auto end() const { return caps.begin() + static_cast<std::ptrdiff_t>(count); }
};

inline Caps caps(const Cylinder& c) { return {{{{Part::base_cap, c.radius}, {Part::top_cap, c.radius}}}, 2}; }
inline Caps caps(const Cone& c) { return {{{{Part::base_cap, c.base_radius}, {Part::top_cap, c.top_radius}}}, 2}; }
inline Caps caps(const Paraboloid& p) { return {{{{Part::top_cap, p.radius}}}, 1}; }
inline Caps caps(const Hyperboloid& h) { return {{{{Part::base_cap, h.radius}, {Part::top_cap, h.radius}}}, 2}; }

/// The hit of a cap inside the range. A ray lying in its plane misses.
template <Scalar T>
std::optional<Root<T>> intersect_cap(const TransformedRay<T>& ray, const AxisView<T>& view, const Cap& cap, Sides sides,
                                     Signs<T>& signs) {
    const bool at_top = cap.part == Part::top_cap;
    const Sign upward = signs.of(view.speed);
    if (upward == Sign::zero || !sees(sides, at_top ? upward : -upward)) return std::nullopt;

    const T way = at_top ? view.squared_length - view.place : -view.place;
    const T radius = ray.length(cap.radius) * view.speed;
    const Vec3<T> moment = view.speed * view.moment + way * view.moment_rate;  // p x g there, times the speed
    if (signs.of(view.squared_length * (radius * radius) - dot(moment, moment)) == Sign::negative) return std::nullopt;
    const Root<T> t = ratio(way, view.speed);
    return is_within(t, ray.range, signs) ? std::optional(t) : std::nullopt;
}

template <class S>
concept SurfaceOfRevolution =
    std::same_as<S, Cylinder> || std::same_as<S, Cone> || std::same_as<S, Paraboloid> || std::same_as<S, Hyperboloid>;

/// Side before caps, base before top, where they are hit at the same t (at a rim).
template <Scalar T, SurfaceOfRevolution S>
std::optional<Intersection<T>> intersect(const TransformedRay<T>& ray, const S& shape, Sides sides, Signs<T>& signs) {
    const AxisView<T> axis = view(ray, shape.base, shape.top);
    std::optional<Intersection<T>> nearest;
    const auto side = first_zero(along(ray, shape, axis), signs, [&](const Root<T>& t, Sign outward) {
        return sees(sides, outward) && is_within(t, ray.range, signs) &&
               sign_at(t, axis.place, axis.speed, signs) != Sign::negative &&
               sign_at(t, axis.place - axis.squared_length, axis.speed, signs) != Sign::positive;
    });
    if (side) nearest = {*side, Part::side};
    if (shape.ends == Ends::open) return nearest;
    for (const Cap& cap : caps(shape)) {
        if (cap.radius == 0) continue;  // an apex belongs to the side, which a ray along its generator misses
        const auto t = intersect_cap(ray, axis, cap, sides, signs);
        // t is the quotient -b/a: nearest - t has the sign of (b + a nearest) / a
        const auto nearer = [&] { return signs.of(t->a) * sign_at(nearest->t, t->b, t->a, signs) == Sign::positive; };
        if (t && (!nearest || nearer())) nearest = {*t, cap.part};
    }
    return nearest;
}

}  // namespace raylab
