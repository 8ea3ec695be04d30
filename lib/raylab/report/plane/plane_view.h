#pragma once

#include "raylab/accelerator/outline.h"
#include "raylab/geometry/affine.h"
#include "raylab/report/plane/plane_drawing.h"

#include <optional>
#include <vector>

// Space as a drawing shows it: seen along an axis, or cut across it. For the eye: nothing here decides anything.

namespace raylab {

/// Points and edges whose convex hull is what is drawn; `piece` of a shape that is not convex.
struct Wires {
    std::vector<Vec3d> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
};

/// A shape in convex pieces at its place; none for a plane. A mesh: one triangle.
std::vector<Wires> wires_of(const Shape& shape, std::uint32_t part, const Affine& placement);

/// Looks along an axis (0: x, 1: y, 2: z) from its positive end, at everything or at what a slice cuts.
class PlaneView {
public:
    /// `shown`: boxes that reach beyond it (some reach to infinity) are drawn as far as there.
    PlaneView(int along, std::optional<double> slice, const Box& shown);

    PlanePoint at(const Vec3d& point) const;

    /// What is seen of a bound; absent where the slice passes it by.
    std::optional<PlaneFigure> figure(const Bound& bound) const;
    std::optional<PlaneFigure> figure(const Wires& wires) const;

    const Box& shown() const { return shown_; }

private:
    int along_;
    std::optional<double> slice_;
    Box shown_;
};

}  // namespace raylab
