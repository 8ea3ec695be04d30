#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <vector>

namespace raylab {

/// How the edges of boxes are drawn into a picture.
struct BoxEdges {
    Pixel color = {0.0f, 0.17f, 0.45f};
    double width = 1.6;  // in pixels
    double behind = 0;   // the share of the colour where a surface hides the edge
};

/// A rendered picture with the edges of boxes in it, as the same camera sees them. `surfaces` decides what is hidden.
Image with_boxes(Image picture, const CameraFrame& frame, const Accelerator& surfaces, const std::vector<Box>& boxes,
                 const BoxEdges& edges = {});

}  // namespace raylab
