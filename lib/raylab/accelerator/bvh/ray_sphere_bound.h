#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raylab {

/// A ray prepared for tests against many bounding spheres, in doubles. It never misses a sphere that it exactly hits.
///
/// With v = center - origin, the ray is closest to the center at t = v.d / d.d, where the distance is that of w = v - t
/// d. All roundings on the way, with u = 2^-53, shift the closest point by at most 8 u |v| and w by at most 4 u |v|,
/// and a shifted w is only longer than the shortest one: so with a radius enlarged by e >= 12 u |v| + 4 u r neither the
/// sphere nor any part of the ray inside it is lost, and another e makes up for the rounding of that part's ends.
/// Floats in doubles neither under- nor overflow. A direction of zero gives NaN, which every comparison treats as
/// inside. (The formula is from Haines, Gunther and Akenine-Moller, Precision Improvements for Ray/Sphere Intersection,
/// Ray Tracing Gems, 2019.)
class SphereBoundRay {
public:
    explicit SphereBoundRay(const Ray& ray)
        : origin_(convert<double>(ray.origin)), direction_(convert<double>(ray.direction)), start_(ray.range.min) {
        const double square = dot(direction_, direction_);
        inverse_square_ = 1 / square;
        inverse_length_ = 1 / std::sqrt(square);
        set_end(ray.range.max);
    }

    /// Ends the ray at t.
    void set_end(double t) { end_ = std::min(t, std::numeric_limits<double>::max()); }

    /// For each of two spheres a lower bound of t inside it, or infinity if the ray surely misses it.
    std::array<double, 2> entries(const std::array<Sphere, 2>& spheres) const {
        return {entry(spheres[0]), entry(spheres[1])};
    }

    double entry(const Sphere& sphere) const {
        constexpr double missed = std::numeric_limits<double>::infinity();
        const Vec3d v = convert<double>(sphere.center) - origin_;
        const double error = slack * (std::abs(v.x) + std::abs(v.y) + std::abs(v.z) + sphere.radius);
        const double reach = sphere.radius + error;
        if (!(reach >= 0)) return missed;  // the bound of an empty set has a negative radius
        const double middle = dot(v, direction_) * inverse_square_;
        const Vec3d w = v - direction_ * middle;
        const double half_square = reach * reach - dot(w, w);
        if (half_square < 0) return missed;
        const double half = (std::sqrt(half_square) + error) * inverse_length_;
        const double near = middle - half, far = middle + half;
        if (far < start_ || near > end_) return missed;
        return near > start_ ? near : start_;
    }

    /// Whether a sphere that the ray enters at t is still reached before the ray's end.
    bool reaches(double t) const { return t <= end_; }

private:
    static constexpr double slack = 32 * unit_roundoff<double>;

    Vec3d origin_, direction_;
    double inverse_square_, inverse_length_;
    double start_, end_;
};

}  // namespace raylab
