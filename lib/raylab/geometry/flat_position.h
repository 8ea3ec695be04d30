#pragma once

#include "raylab/geometry/sphere_position.h"

// What surface_position() says of planes, disks and polygons.

namespace raylab {

/// The plane that a flat shape lies in, with what does not depend on the point near it that is put back onto it.
class FlatPosition {
public:
    FlatPosition(const Vec3d& point, const Vec3d& normal);
    explicit FlatPosition(const Plane& plane);
    explicit FlatPosition(const Disk& disk);
    explicit FlatPosition(const Polygon& polygon);

    /// The foot of the perpendicular from p.
    Vec3d foot(const Vec3d& p) const { return p - normal_ * (dot(p - point_, normal_) / square_); }

    /// How large the numbers are that it is made of.
    double size(const Vec3d& p) const {
        return detail::size_of(p) + size_ + detail::size_of(p - point_) * tilt_ * sums_;
    }

    /// Where the shape lies as it was made.
    SurfacePosition at(const Vec3d& p) const { return {foot(p), detail::rounding_error(size(p)), unit_normal_}; }

    const Vec3d& normal() const { return normal_; }  // its largest coordinate is one

private:
    Vec3d point_, normal_;
    double square_;  // of the normal
    Vec3d unit_normal_;
    double size_;                 // of the point
    double tilt_ = 0, sums_ = 1;  // of a polygon's normal, and of how many roundings it is
};

}  // namespace raylab
