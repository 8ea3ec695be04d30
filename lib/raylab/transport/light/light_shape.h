#pragma once

#include "raylab/geometry/vector.h"

#include <array>
#include <optional>
#include <variant>

// The shapes of lights at their place in the scene, in doubles. Each has the same three functions: its area; a point of
// it, with the density per steradian with which `from` gets it; and that density for a point known already. Whether the
// point faces `from` is not asked: a light may have two sides.

namespace raylab {

/// A point of a light's surface.
struct SurfaceSample {
    Vec3d point, normal;  // normal: unit, outward
    double pdf;           // per steradian at the lit point
};

/// By solid angle: from outside the cone in which it is seen, from inside all directions.
struct SphereLight {
    Vec3d center;
    double radius;

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// The image of the unit sphere under an affine map: its points, uniform over the unit sphere's area, carried along.
struct EllipsoidLight {
    Vec3d center;
    std::array<Vec3d, 3> axes;  // the images of x, y and z

    double area() const;  // to 2 %: it only decides how often the light is chosen
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// By solid angle, or by area where that is below SphericalTriangle's smallest.
struct TriangleLight {
    Vec3d a, b, c;  // counter-clockwise seen from the side of the normal

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// By solid angle, or by area where that is below SphericalRectangle's smallest, or where a motion has sheared it.
struct RectangleLight {
    Vec3d corner, first, second;  // the normal is that of first x second

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// A triangle that is a part of a polygon, by area: so the density is the same in all parts.
struct PolygonLight {
    Vec3d a, b, c;  // as those of TriangleLight

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// A disk or a ring, or the ellipse that a placement makes of it, by area.
struct DiskLight {
    Vec3d center, first, second;  // the images of x and y; the normal is that of first x second
    double inner = 0;             // the hole's radius as a share of the disk's

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

using LightShape = std::variant<SphereLight, EllipsoidLight, TriangleLight, RectangleLight, PolygonLight, DiskLight>;

}  // namespace raylab
