#pragma once

#include "raylab/experiment/structure/structure_method.h"
#include "raylab/image/image.h"
#include "raylab/report/chapter.h"
#include "raylab/report/structure/structure_drawing.h"

#include <string>
#include <vector>

// Every structure of a chapter in the same three drawings: the way of a ray, the tree of its nodes, the cost of each
// pixel.

namespace raylab {

/// Draws for each structure the way of a ray through it (way_of_NAME.svg) and its upper nodes as a tree, with those on
/// the way marked (tree_of_NAME.svg), and shows them on the page. The title of the view is replaced by the structure's
/// name.
void tell_portraits(const ChapterRun& run, Page& page, const std::vector<StructureMethod>& methods, const Scene& scene,
                    const Ray& ray, const StructureView& view = {});

/// Primitive tests for each pixel of the scene: a map for each structure, side by side in the same colours.
Image tests_of_each(const ChapterRun& run, const std::vector<StructureMethod>& methods, const Scene& scene);

}  // namespace raylab
