#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"
#include "raylab/report/stability.h"

#include <optional>
#include <string>
#include <vector>

// A single ray and a single shape as the example of a stability case, in words and drawn. A drawing is for the eye: it
// ignores rounding, and no decision depends on it.

namespace raylab {

/// In the plane of the ray and the sphere's centre.
CaseExample example_of(const Ray& ray, const Sphere& sphere, TrueAnswer truth);

/// Seen along the ray, which is a point.
CaseExample example_of(const Ray& ray, const Triangle& triangle, TrueAnswer truth);
CaseExample example_of(const Ray& ray, const Box& box, TrueAnswer truth);

/// The triangles seen along the ray, which is a point; `truth` is the line below.
PlaneDrawing seen_along(const RayOf<double>& ray, const std::vector<TriangleOf<double>>& triangles,
                        const std::string& truth);

/// The numbers of a ray, from which it can be made again.
std::string in_words(const Ray& ray);

/// A plane in space, in which a case is drawn: the origin, and two directions of length 1 at right angles.
struct CasePlane {
    Vec3d origin, right, up;

    PlanePoint at(const Vec3d& point) const { return {dot(point - origin, right), dot(point - origin, up)}; }
    /// The line in which a triangle crosses the plane; absent where it does not.
    std::optional<PlanePolygon> section(const TriangleOf<double>& triangle) const;
};

/// A plane through a ray, whose origin is the plane's and whose direction is `right`, and as near to `beside` as can
/// be.
CasePlane plane_along(const RayOf<double>& ray, const Vec3d& beside);

/// A drawing of the size of a case's, which shows all of these points and a margin around them.
PlaneDrawing case_drawing_around(const std::vector<PlanePoint>& points);

}  // namespace raylab
