#pragma once

#include "raylab/geometry/vector.h"

namespace raylab {

/// A rectangle as it is seen from a point, and its points uniform per steradian (Urena, Fajardo and King, "An
/// Area-Preserving Parametrization for Spherical Rectangles", Eurographics Symposium on Rendering 2013).
class SphericalRectangle {
public:
    /// Steradians. What looks smaller loses digits, and is sampled by area as well.
    static constexpr double smallest = 1e-6;

    /// The sides leave the corner at a right angle. `from` does not lie in the rectangle's plane.
    SphericalRectangle(const Vec3d& from, const Vec3d& corner, const Vec3d& first_side, const Vec3d& second_side);

    double solid_angle() const { return solid_angle_; }  // steradians
    double pdf() const { return 1 / solid_angle_; }

    /// The point of the rectangle of two numbers in [0, 1).
    Vec3d point(double u, double v) const;

private:
    Vec3d from_, x_, y_, z_;         // z leads from the plane to `from`
    double x0_, x1_, y0_, y1_, z0_;  // the rectangle's bounds and plane in that frame; z0 is negative
    double b0_, b1_, k_, solid_angle_;
};

}  // namespace raylab
