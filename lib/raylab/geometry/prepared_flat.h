#pragma once

#include "raylab/geometry/verdict.h"

#include <array>
#include <cstddef>
#include <vector>

namespace raylab {

/// A plane, disk or polygon at rest, with what does not depend on the ray computed once: many rays meet it, and most are
/// decided by a dozen multiplications. Its answers are those of intersect() on the shape, which are made here too.
class PreparedFlat {
public:
    explicit PreparedFlat(const Plane& plane);
    explicit PreparedFlat(const Disk& disk);
    explicit PreparedFlat(const Polygon& polygon);

    /// The hit inside ray.range, as far as plain doubles can tell.
    FilterVerdict meet(const Ray& ray, Sides sides) const;

    std::size_t bytes() const { return outline_.capacity() * sizeof(outline_[0]); }  // beyond its own

private:
    enum class Extent { unbounded, disk, polygon };

    // How far the point at t, as computed, may lie from the exact one, along each axis.
    struct Point {
        Vec3d at, error;
    };
    // Along a ray to the plane.
    struct Flight {
        const Vec3d& origin;
        const Vec3d& direction;
        double t, t_error;

        Point end() const;
    };
    enum class Inside { yes, no, unknown };

    Inside inside(const Flight& flight) const;
    Inside clearly_inside_disk(const Flight& flight) const;
    Inside inside_disk(const Point& point) const;
    Inside inside_polygon(const Point& point) const;

    Extent extent_;
    Vec3d point_, normal_;
    Vec3d normal_error_{0, 0, 0};  // a polygon's normal is a rounded sum
    double radius_ = 0;            // of a disk
    // Of a polygon: its vertices without the coordinate along the normal's dominant axis, the first one again at the end.
    int first_ = 0, second_ = 1;
    std::vector<std::array<double, 2>> outline_;
};

}  // namespace raylab
