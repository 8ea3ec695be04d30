#pragma once

#include "raylab/accelerator/painters/painters_tree.h"
#include "raylab/scene/camera.h"

#include <limits>

namespace raylab {

/// The triangle that each pixel of a picture shows, and the work it took to paint it.
struct PaintedPicture {
    int width = 0, height = 0;
    // The hit through the center of each pixel, row by row from the top left.
    std::vector<std::optional<Hit>> seen = {};
    std::size_t painted = 0;  // pixels painted, repainting included
    std::size_t tests = 0;    // tests of triangles against eye rays
    // How often the tree left the order of two pieces open, so that their depths were compared.
    std::size_t compared = 0;
};

/// Paints the first `most` pieces of the tree, the farthest first, each over what is already painted. It throws an
/// Error for an orthographic camera.
PaintedPicture paint(const PaintersTree& tree, const CameraFrame& frame,
                     std::size_t largest = std::numeric_limits<std::size_t>::max());

/// A method that is expected to fail: it paints whole triangles in the order of their centers' distances, which is not
/// a correct order.
PaintedPicture paint_by_distance(const PaintersTree& tree, const CameraFrame& frame);

}  // namespace raylab
