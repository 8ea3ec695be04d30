#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/shapes.h"
#include "raylab/number/enclosure.h"

namespace raylab {

/// True if a shape parts space into an inside and an outside: spheres, ellipsoids, capped surfaces of revolution. Of a
/// mesh it is not asked: the answer is no.
bool is_closed(const Shape& shape);

/// True if it is closed and a segment between two points inside never leaves it.
bool is_convex(const Shape& shape);

/// True if the shape lies in one plane. (A mesh does not, though each of its triangles does.)
bool is_planar(const Shape& shape);

/// A small box of space: one enclosure a coordinate.
using Region = Vec3<Enclosure>;

/// The box of all points whose coordinates differ from `center`'s by at most `reach`.
Region region_about(const Vec3d& center, const Vec3d& reach = {0, 0, 0});

enum class Containment { inside, outside, undecided };

/// Classifies the whole region. Inside and outside are proven (interval arithmetic); undecided is what touches the
/// surface, comes within rounding of it, or is too wide to tell. All of space is outside of what is not closed, but for
/// a mesh, whose inside nobody knows: undecided within its bounding box.
Containment containment(const Region& region, const Shape& shape, const Affine& placement);

/// Where the region is with regard to whatever a box bounds, which is placed so: outside, or undecided.
Containment containment_in_bounds(const Region& region, const Box& box, const Affine& placement);

}  // namespace raylab
