#pragma once

#include "raylab/accelerator/painters/painters_picture.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/report/plane/plane_drawing.h"

#include <string>
#include <vector>

// The painter's scenes and pictures.

namespace raylab::split {

/// Three beams that overlap in a ring: each is nearer than the next.
Scene beams();

/// A knot that occludes itself.
Scene knot(int width);

CameraFrame frame_of(const Scene& scene);

/// The painted picture, shaded under a light beside the eye.
Image shaded(const Scene& scene, const PaintedPicture& painted);

/// A painted picture after the first quarters of all pieces.
Image after_quarters(const Scene& scene, const PaintersTree& tree, std::size_t quarters);

/// The number of pixels that show another triangle, or another t, than the ray tracer's.
std::size_t wrong_pixels(const Scene& scene, const PaintedPicture& painted);

/// The pieces as they lie in the picture, numbered in the order of painting.
PlaneDrawing draw_pieces(const Scene& scene, const PaintersTree& tree);

std::vector<std::string> painter_header();
std::vector<std::vector<std::string>> painter_rows(const std::vector<Scene>& scenes);

}  // namespace raylab::split
