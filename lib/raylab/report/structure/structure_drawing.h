#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>

// A structure as a drawing: its cells or boxes, and the way of one ray through them.

namespace raylab {

/// What a drawing shows, and from where.
struct StructureView {
    std::string title = {};
    int along = 2;                     // the axis of the view, from its positive end: 0 x, 1 y, 2 z
    std::optional<double> slice = {};  // only the cut at this coordinate of that axis; absent: everything, projected
    // The part of space; absent: the scene's bounds, and the ray's origin if it is near.
    std::optional<Box> shown = {};
    int width = 720, height = 540;  // in pixels
    std::size_t max_shapes = 4000;  // with more shapes than this they are left out, and a note says so
    std::size_t max_numbers = 60;   // the number of visits that get a number
};

/// Draws every bound of a structure over the scene's shapes: leaves are darker the more primitives they hold, empty
/// ones white.
PlaneDrawing draw_structure(const Scene& scene, const Outline& outline, const StructureView& view);

/// Draws the ray from its origin to its hit, and the cells or nodes that closest() visits for it, numbered in this
/// order: those with tests, empty ones, and inner nodes. The primitives of the cells in which primitives are tested are
/// drawn bold.
PlaneDrawing draw_ray_through(const Scene& scene, const Accelerator& structure, const Ray& ray,
                              const StructureView& view);

}  // namespace raylab
