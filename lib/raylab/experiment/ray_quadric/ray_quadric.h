#pragma once

#include "raylab/experiment/ray_sphere/quadratic.h"
#include "raylab/experiment/ray_sphere/ray_sphere.h"
#include "raylab/geometry/part.h"
#include "raylab/geometry/quadric.h"

#include <optional>
#include <variant>

// A ray hits any quadric where a t^2 + 2 b t + c = 0. Only how the coefficients come from the surface differs, and
// which of the two roots lie on the part of the surface that is there (equations: chapter 02).

namespace raylab {

template <Real T>
struct QuadricHit {
    T t;
    Part part = Part::side;
};

/// An ellipsoid is the unit sphere once every axis is measured in its own radius.
template <Real T>
Quadratic<T> along(const RayOf<T>& ray, const EllipsoidOf<T>& ellipsoid) {
    const Vec3<T> f = (ray.origin - ellipsoid.center) / ellipsoid.radii;
    const Vec3<T> d = ray.direction / ellipsoid.radii;
    return {dot(d, d), dot(f, d), dot(f, f) - 1};
}

/// The ray's height above the base, s = start + t speed, in lengths of the axis.
template <Real T>
struct Height {
    T start, speed;
};

template <Real T>
Height<T> height_along(const RayOf<T>& ray, const Revolution<T>& surface) {
    const T length_squared = dot(surface.axis, surface.axis);
    return {dot(ray.origin - surface.base, surface.axis) / length_squared,
            dot(ray.direction, surface.axis) / length_squared};
}

/// rho^2, the squared distance from the axis along the ray: |(f + t d) x axis|^2 / |axis|^2.
template <Real T>
Quadratic<T> squared_distance_from_axis(const RayOf<T>& ray, const Revolution<T>& surface) {
    const T length_squared = dot(surface.axis, surface.axis);
    const Vec3<T> f = cross(ray.origin - surface.base, surface.axis);
    const Vec3<T> d = cross(ray.direction, surface.axis);
    return {dot(d, d) / length_squared, dot(f, d) / length_squared, dot(f, f) / length_squared};
}

/// rho^2 - q(s) along the ray.
template <Real T>
Quadratic<T> along(const RayOf<T>& ray, const Revolution<T>& surface) {
    const Quadratic<T> rho = squared_distance_from_axis(ray, surface);
    const Height<T> s = height_along(ray, surface);
    return {rho.a - surface.q2 * s.speed * s.speed,             //
            rho.half_b - surface.slope(s.start) / 2 * s.speed,  //
            rho.c - surface.squared_radius(s.start)};
}

/// The t at which the ray crosses the disk that closes a surface of revolution at height s = 0 or 1; absent: it does
/// not.
template <Real T>
std::optional<T> cap_crossing(const RayOf<T>& ray, const Revolution<T>& surface, T s) {
    const Height<T> height = height_along(ray, surface);
    if (height.speed == 0) return std::nullopt;  // parallel to the disk; in it is a miss too
    const T squared_radius = surface.squared_radius(s);
    if (!(squared_radius > 0)) return std::nullopt;  // a cap of radius zero is no cap: an apex belongs to the side
    const T t = (s - height.start) / height.speed;
    const Quadratic<T> rho = squared_distance_from_axis(ray, surface);
    const T rho_squared = (rho.a * t + 2 * rho.half_b) * t + rho.c;
    if (!contains(ray.range, t) || !(rho_squared <= squared_radius)) return std::nullopt;
    return t;
}

/// A closed surface: the first root inside the range.
template <Real T, class Closed>
std::optional<QuadricHit<T>> nearest_quadric_hit(const RayOf<T>& ray, const Closed& surface) {
    const Quadratic<T> quadratic = along(ray, surface);
    const auto t = first_inside(ray.range, stable_roots(quadratic, quadratic.discriminant()));
    if (!t) return std::nullopt;
    return QuadricHit<T>{*t};
}

/// A surface that ends at base and top: a root counts only between them, and a cap may come first.
template <Real T>
std::optional<QuadricHit<T>> nearest_quadric_hit(const RayOf<T>& ray, const Revolution<T>& surface) {
    std::optional<QuadricHit<T>> nearest;
    const auto offer = [&](T t, Part part) {
        if (!nearest || t < nearest->t) nearest = QuadricHit<T>{t, part};
    };
    const Height<T> height = height_along(ray, surface);
    const Interval<T> between_ends{0, 1};
    const Quadratic<T> quadratic = along(ray, surface);
    if (const auto roots = stable_roots(quadratic, quadratic.discriminant()))
        for (const T t : {roots->low, roots->high})
            if (contains(ray.range, t) && contains(between_ends, height.start + t * height.speed)) offer(t, Part::side);
    if (surface.ends == Ends::open) return nearest;
    if (const auto t = cap_crossing<T>(ray, surface, 0)) offer(*t, Part::base_cap);
    if (const auto t = cap_crossing<T>(ray, surface, 1)) offer(*t, Part::top_cap);
    return nearest;
}

/// The nearest hit inside ray.range by one general method: coefficients, stable roots, ends, caps.
template <Real T>
std::optional<QuadricHit<T>> nearest_quadric_hit(const RayOf<T>& ray, const Quadric& quadric) {
    return std::visit([&](const auto& shape) { return nearest_quadric_hit(ray, in<T>(shape)); }, quadric);
}

}  // namespace raylab
