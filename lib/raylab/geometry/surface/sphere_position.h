#pragma once

#include "raylab/geometry/scaled_to_largest_one.h"
#include "raylab/geometry/surface/surface_position.h"

#include <cmath>

// The surface position of spheres.

namespace raylab {

namespace detail {

inline double size_of(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }
inline double size_of(const SphereOf<double>& sphere) { return size_of(sphere.center) + sphere.radius; }

// A point is computed in a few dozen rounded operations on numbers no larger than `size`; each costs half a unit.
constexpr double roundings = 64;
inline double rounding_error(double size) { return roundings * unit_roundoff<double> * size; }

}  // namespace detail

/// The way from a sphere's center to a point near its surface: a unit direction, the outward normal, and where it ends
/// on the sphere.
struct OnSphere {
    Vec3d point, normal;
};

inline OnSphere on_sphere(const SphereOf<double>& sphere, const Vec3d& near) {
    Vec3d from_center = near - sphere.center;
    const double distance = glm::length(from_center);
    // Any point will do on a sphere so small that rounding leaves no direction from its center.
    if (!(distance > 0)) [[unlikely]]
        return {sphere.center + Vec3d{0, 0, sphere.radius}, {0, 0, 1}};
    Vec3d normal = from_center * (1 / distance);
    return {sphere.center + normal * sphere.radius, normal};
}

/// A sphere that is not transformed, with whatever does not depend on the ray computed once.
class PreparedSphere {
public:
    explicit PreparedSphere(const Sphere& sphere)
        : whole_{convert<double>(sphere.center), sphere.radius},
          error_(detail::rounding_error(detail::size_of(whole_))) {}

    /// The point of the surface near p.
    SurfacePosition position(const Vec3d& p) const {
        auto [point, normal] = on_sphere(whole_, p);
        return {point, error_, normal};
    }

private:
    SphereOf<double> whole_;
    double error_;
};

}  // namespace raylab
