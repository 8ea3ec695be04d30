#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

// The finest possible cells of an octree, numbered: every cell of an octree is a cube of 2^k of them along each side.
// So where a cell begins and which cells are its neighbours is computed in integers, and only where a ray crosses a
// plane is rounded.

namespace raylab {

/// act(0), act(1), act(2). Written out, a loop of three is surely unrolled.
template <class Act>
void for_each_axis(const Act& act) {
    act(std::size_t{0});
    act(std::size_t{1});
    act(std::size_t{2});
}

/// The finest cell in which a point lies, or the lowest one of a larger cell.
using LatticeCell = std::array<std::int32_t, 3>;

/// A range of cells, both ends included.
struct LatticeRange {
    LatticeCell first, last;
};

/// A cube of 2^16 cells along each side with the scene's box in its lowest corner, one cell away from the sides. The
/// planes between cells are at origin + k width: as exact numbers, which are never computed.
class Lattice {
public:
    static constexpr int bits = 16;
    static constexpr std::int32_t side = 1 << bits;

    /// The largest error, in cells, of a point by which a ray looks for its cell (LatticeRay, ParametricWalk). Every
    /// box is grown by this much.
    static constexpr double slack = 0x1p-6;

    explicit Lattice(const Box& all);  // the box is finite, or empty where no box will ever be asked about

    /// Every cell that a box, grown by the slack, touches.
    LatticeRange touched(const Box& box) const;

    /// A coordinate in cells; it errs by less than the slack where it is one of the scene's.
    double place(std::size_t axis, double coordinate) const { return (coordinate - origin_[axis]) / width_; }

    /// A cube of 2^size cells along each side, rounded to floats for drawings.
    Box box(const LatticeCell& lowest, int size) const;

    double width() const { return width_; }
    // The upper end of the scene's box, in cells; the lower end is at 1.
    double top(std::size_t axis) const { return top_[axis]; }

private:
    std::array<double, 3> origin_{}, top_{};
    double width_ = 1;
};

/// A ray in units of the lattice's cells. Axes along which it goes backward are mirrored, so that its cell numbers grow
/// along all axes.
///
/// a = (o - origin) / width and s = d / width are rounded twice and once, a plane's t = (k - a) / s three times more,
/// and a point's place a + s t twice: with u = 2^-53 what is computed belongs to a place on the ray at most 8 u (|a| +
/// side) cells away. Where |a| <= 2^40, that is less than `slack`: so at every t between entering a cell and leaving
/// it, the ray's exact point is at most `slack` away from the cell, and every box that holds this point was put there.
/// Floats in doubles neither under- nor overflow on the way. For a ray inside a plane, t is 0 * infinity = NaN there,
/// which every comparison passes over.
class LatticeRay {
public:
    LatticeRay(const Lattice& lattice, const Ray& ray) : start_(ray.range.min), end_(ray.range.max) {
        constexpr double clear = 0.5;  // of a cell, far more than the slack
        bool fits = !(ray.direction.x == 0 && ray.direction.y == 0 && ray.direction.z == 0);
        for_each_axis([&](std::size_t axis) {
            const double direction = ray.direction[static_cast<int>(axis)];
            const double place = lattice.place(axis, ray.origin[static_cast<int>(axis)]);
            const bool backward = direction < 0;
            place_[axis] = backward ? Lattice::side - place : place;
            speed_[axis] = std::abs(direction) / lattice.width();
            pace_[axis] = lattice.width() / std::abs(direction);
            mirrored_[axis] = backward ? -1 : 0;
            fits = fits && std::abs(place) <= farthest && speed_[axis] < std::numeric_limits<double>::infinity();
            const double bottom = 1 - clear, top = lattice.top(axis) + clear;
            const double entry = reaches(axis, backward ? Lattice::side - top : bottom);
            const double exit = reaches(axis, backward ? Lattice::side - bottom : top);
            if (entry > start_) start_ = entry;
            if (exit < end_) end_ = exit;
        });
        fits_ = fits;
    }

    /// Whether the error bounds above hold. They do not for rays that start very far away, that have a direction of
    /// zero, or whose numbers are not finite: those have to be tested against every primitive.
    bool fits_lattice() const { return fits_; }

    /// The range of t in which the ray is inside the scene's box and its own range; start > end where there is none.
    double start() const { return start_; }
    double end() const { return end_; }

    /// The t at which the ray reaches a plane between cells.
    double reaches(std::size_t axis, double plane) const { return (plane - place_[axis]) * pace_[axis]; }

    /// In cells along an axis: how many the ray passes while t grows by 1, the other way around, and where it is at t.
    double speed(std::size_t axis) const { return speed_[axis]; }
    double pace(std::size_t axis) const { return pace_[axis]; }
    double place(std::size_t axis, double t) const { return place_[axis] + speed_[axis] * t; }

    /// The cell, one of first..last along an axis, in which the ray is at t.
    std::int32_t cell(std::size_t axis, double t, std::int32_t first, std::int32_t last) const {
        return std::clamp(static_cast<std::int32_t>(place(axis, t)), first, last);
    }

    /// -1 along a mirrored axis, else 0. cell ^ mirrored, restricted to the lattice's bits, is the cell's number in the
    /// lattice.
    std::int32_t mirrored(std::size_t axis) const { return mirrored_[axis]; }

    /// The lattice's number of the lowest cell of a cube of 2^size cells along each side.
    LatticeCell as_lattice_counts(const LatticeCell& cell, int size) const {
        LatticeCell result{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            result[axis] = (cell[axis] ^ mirrored_[axis]) & (Lattice::side - 1) & -(1 << size);
        return result;
    }

private:
    static constexpr double farthest = 0x1p40;

    std::array<double, 3> place_, speed_, pace_;
    std::array<std::int32_t, 3> mirrored_;
    double start_, end_;
    bool fits_;
};

}  // namespace raylab
