#pragma once

#include "raylab/report/plane/plane_drawing.h"

namespace raylab {

/// The arc of the smaller angle at `corner`, from the direction of `from` to that of `to`.
PlaneDrawing::Arc angle_arc(PlanePoint corner, PlanePoint from, PlanePoint to, double radius,
                            const PlaneStyle& style = {});

/// The two short lines that mark a right angle at `corner`, between the directions of `one` and `other`.
PlaneDrawing::Path right_angle(PlanePoint corner, PlanePoint one, PlanePoint other, double size,
                               const PlaneStyle& style = {});

/// Words beyond the middle of an arc, this many pixels from it.
PlaneDrawing::Text beside_arc(const PlaneDrawing::Arc& arc, const std::string& words, double pixels,
                              double height = 12);

}  // namespace raylab
