#pragma once

#include "raylab/geometry/surface/sphere_position.h"

// The surface position of planes, disks and polygons, and of the caps of surfaces of revolution.

namespace raylab {

/// The plane that a flat shape lies in. It puts points near it back onto itself; whatever does not depend on the point
/// is computed once.
class SurfacePlane {
public:
    SurfacePlane(const Vec3d& point, const Vec3d& normal);
    explicit SurfacePlane(const Plane& plane);
    explicit SurfacePlane(const Disk& disk);
    explicit SurfacePlane(const Annulus& annulus);
    explicit SurfacePlane(const Polygon& polygon);

    /// The foot of the perpendicular from p.
    Vec3d foot(const Vec3d& p) const { return p - normal_ * (dot(p - point_, normal_) / square_); }

    /// The size of the numbers that the foot is computed from: its rounding error is proportional to it.
    double size(const Vec3d& p) const {
        return detail::size_of(p) + size_ + detail::size_of(p - point_) * tilt_ * sums_;
    }

    /// The foot with its error bound, of a shape that is not transformed.
    SurfacePosition position(const Vec3d& p) const { return {foot(p), detail::rounding_error(size(p)), unit_normal_}; }

    const Vec3d& point() const { return point_; }
    const Vec3d& normal() const { return normal_; }  // its largest coordinate is one

private:
    Vec3d point_, normal_;
    double square_;  // of the normal
    Vec3d unit_normal_;
    double size_;                 // of the point
    double tilt_ = 0, sums_ = 1;  // of a polygon's normal: its relative error in roundings, and how many are summed
};

}  // namespace raylab
