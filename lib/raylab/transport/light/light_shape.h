#pragma once

#include "raylab/geometry/vector.h"

#include <array>
#include <optional>
#include <variant>

// The shapes of lights at their place in the scene, in doubles. Each has the same three functions: its area; a point of
// it with the density per steradian with which `from` gets it; and that density for a point known already.

namespace raylab {

/// A point of a light's surface.
struct SurfaceSample {
    Vec3d point, normal;  // normal: unit, outward
    double pdf;           // per steradian at the lit point
};

/// By solid angle, from outside the cone that it is seen in, from inside all directions.
struct SphereLight {
    Vec3d center;
    double radius;

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// The image of the unit sphere under an affine map: the sphere's points, uniform over its area, carried along.
struct EllipsoidLight {
    Vec3d center;
    std::array<Vec3d, 3> axes;  // the images of x, y and z

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// By solid angle; where that is smaller than `smallest_solid_angle`, or the triangle is a part of a polygon, by area.
struct TriangleLight {
    enum class Measure { solid_angle, area };

    Vec3d a, b, c;
    Measure measure = Measure::solid_angle;

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// By solid angle; where that is smaller than `smallest_solid_angle`, by area.
struct RectangleLight {
    Vec3d corner, first, second;  // the sides are at right angles

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

/// An ellipse with or without a hole of its own form, by area: the image of the disk, or of the ring, around z.
struct DiskLight {
    Vec3d center, first, second;  // the images of x and y
    double inner = 0;             // the hole's radius as a share of the disk's

    double area() const;
    std::optional<SurfaceSample> sample(const Vec3d& from, const std::array<double, 2>& numbers) const;
    double pdf(const Vec3d& from, const Vec3d& point) const;
};

using LightShape = std::variant<SphereLight, EllipsoidLight, TriangleLight, RectangleLight, DiskLight>;

/// Steradians. Of smaller solid angles the closed forms lose digits, while the area in which a light is seen varies
/// little over it.
inline constexpr double smallest_solid_angle = 1e-6;

}  // namespace raylab
