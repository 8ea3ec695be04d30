#pragma once

#include "raylab/accelerator/bvh/box_split.h"

#include <span>

namespace raylab {

/// The box and the work of the parts on one side of a cut.
struct CutSide {
    Box box;
    std::size_t count = 0;

    void add(const CutSide& other) {
        box = unite(box, other.box);
        count += other.count;
    }
    double work() const { return count == 0 ? 0 : surface_area(box) * static_cast<double>(count); }
};

/// Consecutive pieces of a row (bins or sorted primitives): what each adds to the part below a cut, and to the part
/// above. The two differ where a primitive reaches over several pieces: it counts below from its first piece on, and
/// above up to its last.
struct CutPieces {
    std::span<const CutSide> below, above;
};

/// The cheapest of the cuts between neighbouring pieces, where `place(i)` is the coordinate at which piece i begins and
/// may be absent where no cut is possible. `above_work` has room for as many numbers as there are pieces.
template <class Place>
std::optional<BoxSplit> cheapest_cut(const CutPieces& pieces, std::span<double> above_work, int axis,
                                     const Place& place) {
    CutSide above;
    for (std::size_t i = pieces.above.size(); i-- > 1;) {
        above.add(pieces.above[i]);
        above_work[i] = above.work();
    }
    std::optional<BoxSplit> best;
    CutSide below;
    for (std::size_t i = 1; i < pieces.below.size(); ++i) {
        below.add(pieces.below[i - 1]);
        const double cost = below.work() + above_work[i];
        if (best && !(cost < best->cost)) continue;
        if (const auto at = place(i)) best = {axis, *at, cost};
    }
    return best;
}

}  // namespace raylab
