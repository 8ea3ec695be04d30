#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A triangle as it is seen from the origin, on the unit sphere, and its points uniform per steradian (Arvo,
/// "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995).
class SphericalTriangle {
public:
    /// The corners are vectors of any length but zero; no two are opposite or equal in direction.
    SphericalTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

    double solid_angle() const { return solid_angle_; }  // steradians, at most 2 pi; 0: seen edge-on
    double pdf() const { return 1 / solid_angle_; }

    /// The unit direction of two numbers in [0, 1).
    Vec3d direction(double u, double v) const;

private:
    Vec3d a_, b_, c_;  // unit
    double solid_angle_;
    double cosine_a_, sine_a_;  // of the angle at a
    double cosine_side_c_;      // of the side from a to b
};

}  // namespace raylab
