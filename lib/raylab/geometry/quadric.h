#pragma once

#include "raylab/geometry/shapes.h"

#include <variant>

namespace raylab {

/// A shape whose surface is a quadratic equation in x, y, z.
using Quadric = std::variant<Sphere, Ellipsoid, Cylinder, Cone, Paraboloid, Hyperboloid>;

// The same shapes in the number type T that a method computes in. Three forms are enough for all six.

template <Real T>
struct EllipsoidOf {
    Vec3<T> center, radii;
};

/// The common form of cylinder, cone, paraboloid and hyperboloid (the frame of shapes.h): rho^2 = q(s), 0 <= s <= 1,
/// with s = (P - base).axis / |axis|^2 along the axis and rho the distance from it; q(s) = q0 + q1 s + q2 s^2.
template <Real T>
struct Revolution {
    Vec3<T> base, axis;  // axis = top - base
    T q0, q1, q2;
    Ends ends;

    T squared_radius(T s) const { return q0 + s * (q1 + s * q2); }
    T slope(T s) const { return q1 + 2 * q2 * s; }  // q'(s)
};

template <Real T>
SphereOf<T> in(const Sphere& sphere) {
    return {convert<T>(sphere.center), cast<T>(sphere.radius)};
}

template <Real T>
EllipsoidOf<T> in(const Ellipsoid& ellipsoid) {
    return {convert<T>(ellipsoid.center), convert<T>(ellipsoid.radii)};
}

template <Real T>
Revolution<T> in(const Cylinder& cylinder) {
    const Vec3<T> base = convert<T>(cylinder.base);
    const T radius = cylinder.radius;
    return {base, convert<T>(cylinder.top) - base, radius * radius, 0, 0, cylinder.ends};
}

template <Real T>
Revolution<T> in(const Cone& cone) {
    const Vec3<T> base = convert<T>(cone.base);
    const T radius = cone.base_radius;
    const T growth = cast<T>(cone.top_radius) - radius;
    return {base, convert<T>(cone.top) - base, radius * radius, 2 * radius * growth, growth * growth, cone.ends};
}

template <Real T>
Revolution<T> in(const Paraboloid& paraboloid) {
    const Vec3<T> base = convert<T>(paraboloid.base);
    const T radius = paraboloid.radius;
    return {base, convert<T>(paraboloid.top) - base, 0, radius * radius, 0, paraboloid.ends};
}

template <Real T>
Revolution<T> in(const Hyperboloid& hyperboloid) {
    const Vec3<T> base = convert<T>(hyperboloid.base);
    const T waist = hyperboloid.waist;
    const T radius = hyperboloid.radius;
    const T growth = (radius - waist) * (radius + waist);  // of rho^2, from the waist to either end
    return {base, convert<T>(hyperboloid.top) - base, radius * radius, -4 * growth, 4 * growth, hyperboloid.ends};
}

}  // namespace raylab
