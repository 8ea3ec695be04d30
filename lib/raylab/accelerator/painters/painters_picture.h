#pragma once

#include "raylab/accelerator/painters/painters_tree.h"
#include "raylab/scene/camera.h"

#include <limits>

namespace raylab {

/// What each pixel of a picture shows, and what it took to paint it.
struct PaintedPicture {
    int width = 0, height = 0;
    std::vector<std::optional<Hit>> seen = {};  // through each pixel's middle, row by row from the top left
    std::size_t painted = 0;                    // pixels, again and again
    std::size_t tests = 0;                      // of triangles against eye rays
    std::size_t compared = 0;  // how often the tree left the order of two pieces open, and their depths were asked
};

/// Paints the first `most` pieces of the tree, the farthest first, each over what is there. Error for an orthographic
/// camera.
PaintedPicture paint(const PaintersTree& tree, const CameraFrame& frame,
                     std::size_t most = std::numeric_limits<std::size_t>::max());

/// Expected to fail: whole triangles, painted in the order of their centers' distance, as if that were an order.
PaintedPicture paint_by_distance(const PaintersTree& tree, const CameraFrame& frame);

}  // namespace raylab
