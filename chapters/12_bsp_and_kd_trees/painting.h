#pragma once

#include "raylab/accelerator/painters/painters_picture.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/report/plane/plane_drawing.h"

#include <string>
#include <vector>

// What the painter paints, and how it is shown.

namespace raylab::split {

/// Three beams that overlap in a ring: each is nearer than the next.
Scene beams();

/// A knot that hides itself.
Scene knot(int width);

CameraFrame frame_of(const Scene& scene);

/// The picture's pixels with a colour each, under a lamp beside the eye.
Image shaded(const Scene& scene, const PaintedPicture& painted);

/// A painted picture after a quarter, a half, three quarters and all of the pieces.
Image steps(const Scene& scene, const PaintersTree& tree);

/// How many pixels show another triangle, or another t, than the ray tracer has.
std::size_t wrong_pixels(const Scene& scene, const PaintedPicture& painted);

/// The pieces as they lie in the picture, numbered as they are painted.
PlaneDrawing draw_pieces(const Scene& scene, const PaintersTree& tree);

std::vector<std::string> painter_header();
std::vector<std::vector<std::string>> painter_rows(const std::vector<Scene>& scenes);

}  // namespace raylab::split
