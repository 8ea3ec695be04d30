#pragma once

#include "raylab/report/plane/plane_view.h"
#include "raylab/report/structure/structure_drawing.h"

#include <cstdint>
#include <set>
#include <span>
#include <string>

namespace raylab {

/// A drawing of a structure while it is made: what is seen, and of which side.
struct StructureCanvas {
    PlaneView view;
    PlaneDrawing drawing;

    /// A figure that the slice does not pass by.
    void figure(const std::optional<PlaneFigure>& shape, const PlaneStyle& style, const std::string& tooltip = {}) {
        if (shape) drawing.marks.push_back(PlaneDrawing::Figure{*shape, style, tooltip});
    }
};

/// Wide enough for the scene, these bounds and the ray's origin, as long as they are not far away.
StructureCanvas empty_canvas(const Scene& scene, const StructureView& view, std::span<const Bound> bounds, const Ray* ray);

/// All shapes, those at `bold` places (as an outline counts them) thick; where there are too many to be seen, only those.
void draw_shapes(StructureCanvas& canvas, const Scene& scene, const StructureView& view, const std::set<std::uint32_t>& bold);

}  // namespace raylab
