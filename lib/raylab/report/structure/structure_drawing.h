#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/report/plane/plane_drawing.h"
#include "raylab/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>

// A structure as a drawing: its cells or boxes, and the way of one ray through them. With
// write_svg(drawing, run.out / "cells.svg") and write_picture(to_image(drawing), run.out, "cells") it is on the page.

namespace raylab {

/// What is looked at, and how.
struct StructureView {
    std::string title = {};
    int along = 2;                       // the axis that is looked along, from its positive end: 0 x, 1 y, 2 z
    std::optional<double> slice = {};    // only what is cut at this coordinate of that axis; absent: all of it, projected
    std::optional<Box> shown = {};       // what part of space; absent: the scene's bounds, and the ray's origin if near
    int width = 720, height = 540;       // pixels
    std::size_t most_shapes = 4000;      // where there are more to draw, shapes are left out, and a note says so
    std::size_t most_numbers = 60;       // so many visits are numbered
};

/// Every bound of a structure over the scene's shapes: leaves darker the more primitives they hold, empty ones white.
PlaneDrawing draw_structure(const Scene& scene, const Outline& outline, const StructureView& view);

/// The ray from its origin to its hit; the cells or nodes that closest() visits for it, numbered in this order: with tests,
/// empty, or inner nodes; the primitives of the cells where something is tested drawn bold.
PlaneDrawing draw_ray_through(const Scene& scene, const Accelerator& structure, const Ray& ray, const StructureView& view);

}  // namespace raylab
