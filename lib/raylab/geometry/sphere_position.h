#pragma once

#include "raylab/geometry/of_size_one.h"
#include "raylab/geometry/surface_position.h"

#include <cmath>

// What surface_position() says of spheres, for who has nothing else.

namespace raylab {

namespace detail {

inline double size_of(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }
inline double size_of(const SphereOf<double>& sphere) { return size_of(sphere.center) + sphere.radius; }

// A point is computed in a few dozen rounded operations on numbers no larger than `size`; each costs half a unit.
constexpr double roundings = 64;
inline double rounding_error(double size) { return roundings * unit_roundoff<double> * size; }

}  // namespace detail

/// A point of a sphere, and the outward normal there, whose largest coordinate is one.
struct OnSphere {
    Vec3d point, normal;
};

/// The point of the sphere on the way from its center to a point near it.
inline OnSphere on_sphere(const SphereOf<double>& sphere, const Vec3d& near) {
    Vec3d from_center = near - sphere.center;
    const double distance = glm::length(from_center);
    if (!(distance > 0)) [[unlikely]] return {sphere.center, {0, 0, 1}};  // so small that rounding leaves no way from its center
    return {sphere.center + from_center * (sphere.radius / distance), from_center / largest_coordinate(from_center)};
}

/// A sphere where it was made, with the error of every point on it.
class SpherePosition {
public:
    explicit SpherePosition(const Sphere& sphere)
        : whole_{convert<double>(sphere.center), sphere.radius}, error_(detail::rounding_error(detail::size_of(whole_))) {}

    SurfacePosition at(const Vec3d& near) const {
        auto [point, normal] = on_sphere(whole_, near);
        return {point, error_, glm::normalize(normal)};
    }

private:
    SphereOf<double> whole_;
    double error_;
};

}  // namespace raylab
