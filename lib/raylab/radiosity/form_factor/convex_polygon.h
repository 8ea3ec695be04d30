#pragma once

#include "raylab/geometry/vector.h"

#include <span>
#include <vector>

// Planar convex polygons, by their vertices: counter-clockwise as seen from the side that sends and receives light.

namespace raylab {

/// The polygon's normal times its area (Newell's sum).
Vec3d area_vector(std::span<const Vec3d> polygon);

double polygon_area(std::span<const Vec3d> polygon);   // m^2
Vec3d polygon_normal(std::span<const Vec3d> polygon);  // of length 1

/// The ball around the mean of the vertices that contains the polygon.
struct PolygonBall {
    Vec3d center;
    double radius;
};
PolygonBall polygon_ball(std::span<const Vec3d> polygon);

/// The distance from a point to the nearest point of the polygon.
double distance_to_polygon(const Vec3d& point, std::span<const Vec3d> polygon);

/// A plane by one of its points and its normal, of length 1, which points to its front.
struct PatchPlane {
    Vec3d point, normal;

    double height(const Vec3d& of) const { return dot(normal, of - point); }
    PatchPlane turned() const { return {point, -normal}; }
};
PatchPlane patch_plane(std::span<const Vec3d> polygon);

/// The height over a plane below which a vertex cannot be told from one on the plane: 1e-14 of the farthest vertex's
/// distance from the origin, some tens of its rounding errors.
double rounding_height(std::span<const Vec3d> polygon);

/// The part of a polygon in front of a plane. Vertices at most `tolerance` behind the plane count as on it, so that a
/// polygon that touches the plane stays whole. Empty where no vertex is further in front of it than the tolerance.
std::vector<Vec3d> clipped_to_front(std::span<const Vec3d> polygon, const PatchPlane& plane, double tolerance);

}  // namespace raylab
