#pragma once

#include "raylab/accelerator/split_tree/plane_rule.h"
#include "raylab/report/chart/chart.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

namespace raylab::split {

/// Walls, the lines that they divide the plane by, the regions in their order from an eye, and the tree.
PlaneDrawing draw_plane_tree();

/// A plane behind a cell's part of a ray, before it, and in it: which halves are visited.
PlaneDrawing draw_three_cases();

/// The expected cost of every cut of the scene's whole box, along each axis, and of none.
CurveChart sweep_chart(const Scene& scene, const SahCosts& costs);

}  // namespace raylab::split
