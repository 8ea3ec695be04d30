#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter_run.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab::octrees {

/// The rendered scene with the leaves that hold something drawn into it.
Image cells_in_picture(const Scene& scene, const ChapterRun& run);

/// The octree after this many cuts, all of them made: a slice just above the floor.
PlaneDrawing draw_cuts(const Scene& scene, int cuts);

/// The ray of the lesson: above the floor from the left, down into the small spheres.
Ray lesson_ray();

/// That ray's leaves in a slice, and the box of all primitives in which its walk begins.
PlaneDrawing draw_way(const Scene& scene);

/// Octrees of the scene, cut deeper and deeper: their cells, and what the rays of the scene's camera cost.
std::vector<std::string> cuts_header();
std::vector<std::vector<std::string>> cuts_rows(const Scene& scene);

}  // namespace raylab::octrees
