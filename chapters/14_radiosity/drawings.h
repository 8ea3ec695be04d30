#pragma once

#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/report/chart/chart.h"
#include "raylab/report/plane/plane_drawing.h"

namespace raylab::cornell {

/// Two small pieces of two patches: the straight way between them, and its angles with both normals.
PlaneDrawing draw_two_patches();

/// A polygon seen from a point: the angle of one edge, and the normal of the plane through the point and the edge.
PlaneDrawing draw_contour();

/// The residual of each iterative solver over its iterations; of shooting over as many shots as make one sweep.
CurveChart residual_chart(const SceneRadiosity& solved);

}  // namespace raylab::cornell
