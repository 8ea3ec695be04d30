#pragma once

#include "raylab/geometry/box.h"
#include "raylab/geometry/shapes.h"

#include <span>
#include <vector>

// What other bounds than boxes are laid around.

namespace raylab {

struct Ball {
    Vec3d center;
    double radius;
};

/// A shape lies in the convex hull of some balls, surely: a triangle's are its three corners, of radius zero where they are
/// exact, a sphere is its own; a disk's are the corners of a 16-gon around it, a cylinder's those of two.
using Hull = std::vector<Ball>;

Hull hull(const Triangle& triangle, const Affine& placement = {});
Hull hull(const Shape& shape, const Affine& placement = {});  // empty: unbounded (a plane)

/// Whether nothing in it reaches to infinity, or nearly there: what is computed from it fits a float.
bool is_finite(std::span<const Ball> hull);

/// The balls that reach farthest along seven directions, pair by pair: what bounds are first tried on. (Larsson, Fast and
/// tight fitting bounding spheres, SIGRAD 2008.)
Hull extremes(std::span<const Ball> balls);

}  // namespace raylab
