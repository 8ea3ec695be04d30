#pragma once

#include "raylab/accelerator/item_buffer/picture_view.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/intersect/nearest.h"

#include <array>
#include <cstddef>

namespace raylab {

/// A primitive as the eye sees it, as a few corners: every eye ray that hits it goes through their convex hull.
struct PictureHull {
    std::array<Vec3d, 8> corners;
    std::size_t count = 0;
    double size = 0;       // no corner's coordinates sum up to more
    double off = 0;        // how far the exact corners may lie from these, metres
    double distance = 0;   // nowhere nearer to the eye does a ray that hits the primitive go through the hull
    double nearest = 0;    // nor the primitive lie
    double thickness = 0;  // how far its depth may differ from the hull's
};

/// The hull of a primitive with bounds, as seen in this picture: a triangle is its own; a sphere at rest has an
/// octagon; all others have their box.
PictureHull picture_hull(const PictureView& view, const Target& target, const Box& box);

}  // namespace raylab
