#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A triangle as it is seen from the origin, on the unit sphere, and its points uniform per steradian (Arvo,
/// "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995).
class SphericalTriangle {
public:
    /// Steradians. What looks smaller loses digits, and is sampled by area as well.
    static constexpr double smallest = 1e-10;

    /// The corners are vectors of any length but zero; no two are opposite or equal in direction.
    SphericalTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

    double solid_angle() const { return solid_angle_; }  // steradians, at most 2 pi; 0: seen edge-on
    double pdf() const { return 1 / solid_angle_; }

    /// The unit direction of two numbers in [0, 1). It errs by some 1e-16, so of a triangle that looks as large as 1e-5
    /// by 1e-11 of its size.
    Vec3d direction(double u, double v) const;

private:
    Vec3d a_, b_;   // unit
    Vec3d a_to_c_;  // the unit tangent at a of the side to c
    double solid_angle_;
    double angle_;   // at a, in radians
    double half_c_;  // the tangent of half the side from a to b
};

}  // namespace raylab
