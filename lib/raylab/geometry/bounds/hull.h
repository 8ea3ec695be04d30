#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <span>
#include <vector>

// Balls whose convex hull contains a shape: bounding volumes other than boxes are fitted around them.

namespace raylab {

struct Ball {
    Vec3d center;
    double radius;
};

/// A shape lies in the convex hull of some balls, surely: a triangle's are its three corners, of radius zero where they
/// are exact, a sphere is its own; a disk's are the corners of a 16-gon around it, a cylinder's those of two.
using Hull = std::vector<Ball>;

Hull hull(const Triangle& triangle, const Affine& placement = {});
Hull hull(const Shape& shape, const Affine& placement = {});  // empty: unbounded (a plane)

/// The corners of a box.
Hull hull(const Box& box);

/// Of what only translates: its balls as they stand at the first and at the last of some times. Every point moves along
/// a straight line, so that it is between them at all times.
Hull swept(const Hull& at_rest, const Vec3f& velocity, const Interval<float>& times);

/// True if nothing in it reaches to infinity, or nearly there: numbers computed from it fit a float.
bool is_finite(std::span<const Ball> hull);

/// The balls that reach farthest along seven directions, pair by pair: what bounds are first tried on. (Larsson, Fast
/// and tight fitting bounding spheres, SIGRAD 2008.)
Hull extremes(std::span<const Ball> balls);

}  // namespace raylab
