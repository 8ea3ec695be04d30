#include "raylab/sampling/mapping/spherical_rectangle.h"

#include "raylab/sampling/mapping/solid_angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab {

namespace {

// 1 / sqrt(1 + (z / x)^2) with the sign of x: the cosine of the angle in which a side's plane leans.
double lean(double x, double z) { return x / std::hypot(x, z); }

}  // namespace

SphericalRectangle::SphericalRectangle(const Vec3d& from, const Vec3d& corner, const Vec3d& first_side,
                                       const Vec3d& second_side)
    : from_(from) {
    const double width = glm::length(first_side), height = glm::length(second_side);
    x_ = first_side / width;
    y_ = second_side / height;
    z_ = cross(x_, y_);
    const Vec3d way = corner - from;
    if (dot(way, z_) > 0) z_ = -z_;
    x0_ = dot(way, x_);
    y0_ = dot(way, y_);
    z0_ = dot(way, z_);
    x1_ = x0_ + width;
    y1_ = y0_ + height;
    const Vec3d opposite = way + first_side + second_side;
    solid_angle_ =
        triangle_solid_angle(way, way + first_side, opposite) + triangle_solid_angle(way, opposite, way + second_side);
    // Of the four planes through `from` and a side, the angles at the two corners of the left side, and the lower and
    // the upper plane's normals along z.
    const double at_upper = std::acos(lean(y1_, z0_) * lean(x0_, z0_));
    const double at_lower = std::acos(-lean(x0_, z0_) * lean(y0_, z0_));
    k_ = 2 * std::numbers::pi - at_upper - at_lower;
    b0_ = -lean(y0_, z0_);
    b1_ = lean(y1_, z0_);
}

// The x for which the part to its left has the share u of the solid angle; then y, whose sine over the line at that x
// is uniform.
Vec3d SphericalRectangle::point(double u, double v) const {
    const double angle = u * solid_angle_ + k_;
    const double f = (std::cos(angle) * b0_ - b1_) / std::sin(angle);
    const double rest = f * f + (b0_ - 1) * (b0_ + 1);  // above 0, up to rounding
    const double x = rest > 0 ? std::clamp((f > 0 ? -z0_ : z0_) / std::sqrt(rest), x0_, x1_) : (f > 0 ? x1_ : x0_);
    const double away = std::hypot(x, z0_);
    const double low = lean(y0_, away), high = lean(y1_, away);
    const double sine = low + v * (high - low);
    const double left = (1 - sine) * (1 + sine);
    const double y = left > 0 ? std::clamp(sine * away / std::sqrt(left), y0_, y1_) : y1_;
    return from_ + x * x_ + y * y_ + z0_ * z_;
}

}  // namespace raylab
