#pragma once

#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

// The surface area heuristic by hand: where to cut the six things of the chapter's scene along x.

namespace raylab::volumes {

/// A row for each cut between neighbours: the numbers of things and the shares of the surface on both sides, and the
/// expected work.
std::vector<std::string> cuts_header();
std::vector<std::vector<std::string>> cuts_rows(const Scene& scene);

/// The scene from the front: the things' boxes, the cuts, and the two boxes below the cheapest one.
PlaneDrawing draw_cuts(const Scene& scene);

}  // namespace raylab::volumes
