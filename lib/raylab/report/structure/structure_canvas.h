#pragma once

#include "raylab/report/plane/plane_view.h"
#include "raylab/report/structure/structure_drawing.h"

#include <cstdint>
#include <set>
#include <span>
#include <string>

namespace raylab {

/// A drawing of a structure in the making: the projection and the marks so far.
struct StructureCanvas {
    PlaneView view;
    PlaneDrawing drawing;

    /// Adds a figure, unless the slice does not cut it.
    void figure(const std::optional<PlaneFigure>& shape, const PlaneStyle& style, const std::string& tooltip = {},
                const PlaneDrawing::Data& data = {}) {
        if (shape) drawing.marks.push_back(PlaneDrawing::Figure{*shape, style, tooltip, data});
    }
};

/// A canvas that is wide enough for the scene, these bounds and the ray's origin, unless they are far away.
StructureCanvas empty_canvas(const Scene& scene, const StructureView& view, std::span<const Bound> bounds,
                             const Ray* ray);

/// Draws all shapes, and those at `bold` places (counted as in an outline) thick; where there are too many to be
/// visible, only the latter.
void draw_shapes(StructureCanvas& canvas, const Scene& scene, const StructureView& view,
                 const std::set<std::uint32_t>& bold);

}  // namespace raylab
