#pragma once

#include "raylab/geometry/filter/carried_ray.h"
#include "raylab/geometry/predicate/verdict.h"
#include "raylab/geometry/surface/surface_plane.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace raylab {

/// A shape in a plane, with whatever does not depend on the ray computed once: most rays are
/// decided by a dozen multiplications.
class PreparedFlat {
public:
    explicit PreparedFlat(const Plane& plane);
    explicit PreparedFlat(const Disk& disk);
    explicit PreparedFlat(const Annulus& annulus);
    explicit PreparedFlat(const Polygon& polygon);

    /// The hit inside ray.range, as far as plain doubles can tell.
    FilterVerdict filter(const Ray& ray, Sides sides) const;

    /// The same of the shape where it stands at the ray's time, if it only translates.
    FilterVerdict filter(const Ray& ray, const Affine& placement, const Motion& motion, Sides sides) const;

    /// The same of the shape where it is placed: the ray, as seen from point().
    FilterVerdict filter(const CarriedRay& ray, Sides sides) const;

    /// The plane's point.
    const Vec3d& point() const { return plane_.point(); }

    /// The point of the surface near p.
    SurfacePosition position(const Vec3d& p) const { return plane_.position(p); }

    std::size_t bytes() const;  // those on the heap included

private:
    // The part of the plane that belongs to the shape.
    struct Everything {};
    struct Circle {
        double radius;
    };
    struct Ring {
        Circle inner, outer;
    };
    // The vertices without the coordinate along the normal's dominant axis, the first one again at the end.
    struct Outline {
        Vec3d normal_error;  // the normal is a rounded sum
        int first, second;   // the two axes that are left
        std::vector<std::array<double, 2>> vertices;
    };
    using Extent = std::variant<Everything, Circle, Ring, Outline>;

    // The point at t as computed, and how far it may lie from the exact one, along each axis.
    struct Point {
        Vec3d at, error;
    };
    // By how much coordinates may be off, beside a rounding of the origin's.
    struct Off {
        double origin = 0, direction = 0;
        double at(double t, double t_error) const { return origin + (std::abs(t) + t_error) * direction; }
    };
    // A ray up to the plane, as seen from the plane's point.
    struct Flight {
        const Vec3d& origin;
        const Vec3d& direction;
        double t, t_error;
        double off;  // of the coordinates of where it ends, beside roundings and the error of t

        Point end() const;
    };
    enum class Inside { yes, no, unknown };

    FilterVerdict filter_seen_from_point(const Vec3d& origin, const Vec3d& direction, const Off& off,
                                         const Interval<float>& range, Sides sides) const;

    static Outline outline(const Polygon& polygon, const Vec3<Enclosure>& normal);
    PreparedFlat(const Polygon& polygon, const Vec3<Enclosure>& normal);

    Inside inside(const Everything&, const Flight&) const { return Inside::yes; }
    Inside inside(const Circle& circle, const Flight& flight) const;
    Inside inside(const Ring& ring, const Flight& flight) const;
    Inside inside(const Outline& outline, const Flight& flight) const;
    Inside clearly_inside(const Circle& circle, const Flight& flight) const;

    SurfacePlane plane_;
    Vec3d normal_;  // as the shape has it
    Extent extent_;
};

}  // namespace raylab
