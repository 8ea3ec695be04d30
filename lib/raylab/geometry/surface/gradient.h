#pragma once

#include "raylab/geometry/part.h"
#include "raylab/geometry/quadric.h"

#include <variant>

// A quadric is where a function F is zero, and F grows fastest straight away from it: its gradient is a normal. It
// points outward and is of no particular length, so it must be normalised before anything is shaded with it.

namespace raylab {

/// F = |P - center|^2 - radius^2.
template <Real T>
Vec3<T> gradient(const SphereOf<T>& sphere, const Vec3<T>& point, Part) {
    return (point - sphere.center) * T(2);
}

/// F = ((x - cx) / rx)^2 + ... - 1.
template <Real T>
Vec3<T> gradient(const EllipsoidOf<T>& ellipsoid, const Vec3<T>& point, Part) {
    return (point - ellipsoid.center) * T(2) / (ellipsoid.radii * ellipsoid.radii);
}

/// F = rho^2 - q(s): twice the way from the axis, less q'(s) along the axis. A cap's is the axis itself.
template <Real T>
Vec3<T> gradient(const Revolution<T>& surface, const Vec3<T>& point, Part part) {
    if (part == Part::base_cap) return -surface.axis;
    if (part == Part::top_cap) return surface.axis;
    const T length_squared = dot(surface.axis, surface.axis);
    const Vec3<T> above_base = point - surface.base;
    const T s = dot(above_base, surface.axis) / length_squared;
    const Vec3<T> from_axis = above_base - surface.axis * s;
    return from_axis * T(2) - surface.axis * (surface.slope(s) / length_squared);
}

/// The gradient at a point of the surface; zero only at an apex.
template <Real T>
Vec3<T> gradient(const Quadric& quadric, const Vec3<T>& point, Part part) {
    return std::visit([&](const auto& shape) { return gradient(in<T>(shape), point, part); }, quadric);
}

/// The unit outward normal of a quadric at a point of its surface; the apex of a cone has none (NaN).
template <Real T>
Vec3<T> gradient_normal(const Quadric& quadric, const Vec3<T>& point, Part part) {
    return glm::normalize(gradient<T>(quadric, point, part));
}

}  // namespace raylab
