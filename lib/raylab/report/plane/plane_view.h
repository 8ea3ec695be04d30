#pragma once

#include "raylab/accelerator/outline.h"
#include "raylab/geometry/affine.h"
#include "raylab/report/plane/plane_drawing.h"

#include <optional>
#include <vector>

// Projects space to a drawing: seen along an axis, or cut across it. It is for the eye: it ignores rounding, and no
// decision depends on it.

namespace raylab {

/// A convex piece of a shape: the points whose convex hull is drawn, and its edges.
struct Wires {
    std::vector<Vec3d> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
};

/// A transformed shape in convex pieces; none for a plane. Of a mesh, it is the triangle `part`.
std::vector<Wires> wires_of(const Shape& shape, std::uint32_t part, const Affine& placement);

/// Looks along an axis (0: x, 1: y, 2: z) from its positive end, at everything or only at the cut by a slice.
class PlaneView {
public:
    /// Boxes that reach beyond `shown` (some reach to infinity) are drawn only inside it.
    PlaneView(int along, std::optional<double> slice, const Box& shown);

    PlanePoint at(const Vec3d& point) const;

    /// The projection of a bound; absent where the slice does not cut it.
    std::optional<PlaneFigure> figure(const Bound& bound) const;
    std::optional<PlaneFigure> figure(const Wires& wires) const;

    const Box& shown() const { return shown_; }

private:
    int along_;
    std::optional<double> slice_;
    Box shown_;
};

}  // namespace raylab
