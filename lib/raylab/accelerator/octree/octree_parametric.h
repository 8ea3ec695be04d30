#pragma once

#include "raylab/accelerator/octree/octree_walk.h"
#include "raylab/number/four_floats.h"

namespace raylab {

/// When a ray reaches planes between the cells of an octree, in floats, four at once: time begins with the walk, and
/// the ray passes a lattice cell in 1 along the axis on which it is fastest.
///
/// With u = 2^-24, a place of less than 2^16 cells is rounded by at most 2^-9, and the time at plane k, (k - place)
/// pace, three times by u of itself: so the ray's point at a time that was computed is at most 2^-9 + 3.1 u 2^16 =
/// 0.0141 cells from the plane. With what LatticeRay errs by, less than 0.001, that is less than `slack`. On an axis
/// that the ray passes less than 2^-60 times as fast, no plane is reached but one in which it begins: another is at
/// least 2^-24 away, which takes 2^36, longer than any walk.
class TimesAtPlanes {
public:
    explicit TimesAtPlanes(const LatticeRay& ray) : start_(ray.start()), fastest_(0), place_{}, pace_{} {
        for_each_axis([&](std::size_t axis) { fastest_ = std::max(fastest_, ray.speed(axis)); });
        for_each_axis([&](std::size_t axis) {
            place_[axis] = static_cast<float>(ray.place(axis, start_));
            pace_[axis] = static_cast<float>(std::min(fastest_ * ray.pace(axis), 0x1p60));
        });
    }

    FourFloats at(FourFloats planes) const { return (planes - place_) * pace_; }

    /// The time of t, or a little later.
    float of(double t) const { return static_cast<float>((t - start_) * fastest_) * (1 + 0x1p-20f); }

private:
    double start_, fastest_;
    FourFloats place_, pace_;
};

/// Goes from leaf to leaf by times alone. Along each axis a block of eight cells has one plane in its middle and one at
/// its far end: until the former's time the ray is in the lower half, and until the latter's in the upper one.
/// (Revelles, Urena and Lastra, An Efficient Parametric Algorithm for Octree Traversal, WSCG 2000.) The octree has only
/// such blocks.
class Parametric {
public:
    explicit Parametric(const OctreeCells&) {}
    static OctreeLimits limits() { return {}; }
    static std::size_t bytes() { return 0; }

    template <class AtLeaf>
    void walk(const OctreeCells& tree, const LatticeRay& ray, std::uint64_t& all_steps, const AtLeaf& at_leaf) const {
        if (!(ray.start() <= ray.end())) return;
        const OctreeCell* const cells = tree.cells.data();
        const std::uint32_t mirrored = mirrored_axes(ray);
        const TimesAtPlanes times(ray);
        double end_t = ray.end();
        float time = 0, end = times.of(end_t);
        // The block of the root is twice as large as the root itself, which is all of its lower halves.
        float width = Lattice::side;                  // of a cell of the block
        FourFloats low{};                             // its lowest cell
        FourInts upper{};                             // along which axes the ray is in the upper half
        std::array<Block, Lattice::bits + 1> blocks;  // by the size of their cells
        Block* block = &blocks.back();
        *block = Block(0, times.at(all_four(width)), FourFloats{});
        const auto visit = [&](const OctreeCell& leaf) {
            const FoundLeaf found{leaf, cell(low + offset(upper, width)), static_cast<int>(block - blocks.data())};
            const double ends = at_leaf(found);
            if (!(ends < end_t)) return;
            end_t = ends;
            end = times.of(ends);
        };
        std::uint64_t steps = 0;
        while (true) {
            ++steps;
            const OctreeCell found = cells[block->first + (three_signs(upper) ^ mirrored)];
            const FourFloats exits = block->exits(upper);
            if (found.is_divided()) {
                block->upper = upper;
                low += offset(upper, width);
                width /= 2;
                *--block = Block(found.first, times.at(low + all_four(width)), exits);
                upper = block->middle <= all_four(time);
                continue;
            }
            visit(found);
            time = std::min({exits[0], exits[1], exits[2]});
            if (!(time <= end)) break;  // the root is left later than the scene's box is
            FourInts left = exits <= all_four(time);
            while (three_signs(left & upper) != 0) {
                upper = (++block)->upper;
                width *= 2;
                low -= offset(upper, width);
                left = block->exits(upper) <= all_four(time);
            }
            upper |= left;
        }
        all_steps += steps;
    }

private:
    // Eight cells: the first of them, when the ray reaches the planes in the middle and at the far end, and along which
    // axes it is in the upper half while it is in a block below.
    struct Block {
        FourFloats middle, far;
        FourInts upper;
        std::uint32_t first;

        Block() = default;
        Block(std::uint32_t first_cell, FourFloats at_middle, FourFloats at_far)
            : middle(at_middle), far(at_far), first(first_cell) {}
        FourFloats exits(FourInts in_upper) const { return in_upper ? far : middle; }
    };

    static std::uint32_t mirrored_axes(const LatticeRay& ray) {
        std::uint32_t axes = 0;
        for_each_axis([&](std::size_t axis) { axes |= static_cast<std::uint32_t>(ray.mirrored(axis)) & (1u << axis); });
        return axes;
    }

    static FourFloats offset(FourInts axes, float width) { return axes ? all_four(width) : FourFloats{}; }

    static LatticeCell cell(FourFloats lowest) {
        const auto along = [&](int axis) { return static_cast<std::int32_t>(lowest[axis]); };
        return {along(0), along(1), along(2)};
    }
};

}  // namespace raylab
