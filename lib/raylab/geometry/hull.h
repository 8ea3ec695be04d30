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

/// A shape lies in the convex hull of some balls: a triangle's are its three corners, of radius zero where they are exact, a
/// sphere is its own, and of any other shape the corners of its box will do.
using Hull = std::vector<Ball>;

Hull hull(const Triangle& triangle, const Affine& placement = {});
Hull hull(const Shape& shape, const Affine& placement = {});  // empty: unbounded (a plane)

/// Whether nothing in it reaches to infinity.
bool is_finite(std::span<const Ball> hull);

}  // namespace raylab
