#pragma once

#include "raylab/accelerator/grid/grid_planes.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/scalar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace raylab {

/// Takes a ray from cell to cell of a grid, near to far (3D-DDA: Fujimoto, Tanaka and Iwata 1986; Amanatides and Woo
/// 1987), in doubles. It provably skips no cell that matters.
///
/// The t at which the ray crosses a plane is computed anew at every step: t = (plane - origin) * (1 / direction) has
/// three roundings, and floats in doubles neither under- nor overflow, so it errs by less than 4 u |t|, however many
/// steps came before. The computed t grows with the plane, as the exact one does. By definition the traversal is, at t,
/// in the cell behind all planes whose *computed* t is not larger. If the ray's point at t lies in another cell, then
/// along each axis that cell is at most a neighbour, and the point lies within 4 u |plane - origin| of the plane
/// between. A primitive is listed in every cell that its box reaches into when it is grown by `slack`, which is more
/// than that (is_sure()). So at the t of a hit the traversal is in a cell that lists the primitive: rounding changes
/// the order of cells and adds some, but loses none. For the same reason the comparisons with the ends of the range and
/// with the nearest hit need no allowance.
class GridWalk {
public:
    GridWalk(const GridPlanes& planes, const Ray& ray) : start_(ray.range.min), end_(ray.range.max) {
        double farthest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& along = planes.along[axis];
            origin_[axis] = ray.origin[static_cast<int>(axis)];
            farthest = std::max({farthest, along.back() - origin_[axis], origin_[axis] - along.front()});
            inverse_[axis] = 1 / double{ray.direction[static_cast<int>(axis)]};
            clip(axis, along);
        }
        is_sure_ = 8 * unit_roundoff<double> * farthest <= planes.slack;
        std::ptrdiff_t stride = 1;
        for (std::size_t axis = 0; axis < 3 && is_sure_ && enters(); ++axis) {
            set_out(axis, planes.along[axis], double{ray.direction[static_cast<int>(axis)]}, stride);
            stride *= static_cast<std::ptrdiff_t>(planes.along[axis].size()) - 1;
        }
    }

    /// Whether the proof holds. If not, the ray starts so far away that doubles cannot tell its cells, and the grid
    /// must not be traversed.
    bool is_sure() const { return is_sure_; }

    /// Whether the ray enters the grid within its range.
    bool enters() const { return start_ <= end_; }

    /// Ends the ray at t.
    void set_end(double t) { end_ = std::min(end_, t); }

    /// Goes to the next cell; false if there is none before the end.
    [[gnu::always_inline]] bool next() {
        if (t_[0] <= t_[1]) return t_[0] <= t_[2] ? cross<0>() : cross<2>();
        return t_[1] <= t_[2] ? cross<1>() : cross<2>();
    }

    /// The index of the current cell, as GridPlanes::index computes it.
    std::size_t index() const { return static_cast<std::size_t>(index_); }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    // Crosses the next plane of an axis. Each axis has code of its own, because the processor then predicts better
    // which one is next.
    template <std::size_t axis>
    [[gnu::always_inline]] bool cross() {
        if (!(t_[axis] <= end_) || --left_[axis] == 0) return false;
        index_ += stride_[axis];
        plane_[axis] += step_[axis];
        t_[axis] = t_of(axis, *plane_[axis]);
        return true;
    }

    double t_of(std::size_t axis, double plane) const { return (plane - origin_[axis]) * inverse_[axis]; }
    bool is_still(std::size_t axis) const { return std::isinf(inverse_[axis]); }  // 1 / a float is finite, except 1 / 0

    // Limits the range of t to where the ray is inside the grid.
    void clip(std::size_t axis, const std::vector<double>& planes) {
        if (is_still(axis)) {  // t would be infinite, or 0 * infinity
            if (!(planes.front() <= origin_[axis] && origin_[axis] <= planes.back())) end_ = -infinity;
            return;
        }
        const double a = t_of(axis, planes.front()), b = t_of(axis, planes.back());
        start_ = std::max(start_, std::min(a, b));
        end_ = std::min(end_, std::max(a, b));
    }

    // Sets up the first cell of an axis and the steps ahead of it.
    void set_out(std::size_t axis, const std::vector<double>& planes, double direction, std::ptrdiff_t stride) {
        const int cells = static_cast<int>(planes.size()) - 1;
        int cell = guess(planes, is_still(axis) ? origin_[axis] : origin_[axis] + start_ * direction);
        if (is_still(axis)) {
            while (cell > 0 && planes[static_cast<std::size_t>(cell)] > origin_[axis]) --cell;
            while (cell < cells - 1 && planes[static_cast<std::size_t>(cell) + 1] <= origin_[axis]) ++cell;
            t_[axis] = infinity;
            left_[axis] = 1;
        } else if (direction > 0) {
            while (cell > 0 && t_of(axis, planes[static_cast<std::size_t>(cell)]) > start_) --cell;
            while (cell < cells - 1 && t_of(axis, planes[static_cast<std::size_t>(cell) + 1]) <= start_) ++cell;
            left_[axis] = cells - cell;
        } else {
            while (cell < cells - 1 && t_of(axis, planes[static_cast<std::size_t>(cell) + 1]) > start_) ++cell;
            while (cell > 0 && t_of(axis, planes[static_cast<std::size_t>(cell)]) <= start_) --cell;
            left_[axis] = cell + 1;
        }
        step_[axis] = direction < 0 ? -1 : 1;
        stride_[axis] = step_[axis] * stride;
        index_ += cell * stride;
        plane_[axis] = planes.data() + cell + (direction < 0 ? 0 : 1);
        if (!is_still(axis)) t_[axis] = t_of(axis, *plane_[axis]);
    }

    // A cell near the coordinate's. The planes are equally spaced except for rounding and the outermost two.
    static int guess(const std::vector<double>& planes, double coordinate) {
        const double cells = static_cast<double>(planes.size()) - 1;
        const double place = (coordinate - planes.front()) / (planes.back() - planes.front()) * cells;
        return static_cast<int>(std::clamp(place, 0.0, cells - 1));
    }

    double start_, end_;
    std::array<double, 3> origin_, inverse_, t_;  // t_: of the next plane of each axis
    std::array<const double*, 3> plane_;
    std::array<std::ptrdiff_t, 3> step_, stride_;
    std::array<int, 3> left_;  // cells from the current one to the end of the grid, both included
    std::ptrdiff_t index_ = 0;
    bool is_sure_ = false;
};

}  // namespace raylab
