#pragma once

#include "raylab/accelerator/primitives.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raylab {

/// A scene's primitives as a structure receives them: the bounded ones, which it sorts, and the unbounded ones
/// (planes), against which every ray is tested.
struct SortedPrimitives {
    Primitives all;                                 // in scene order
    std::vector<std::uint32_t> bounded, unbounded;  // places in `all`, ascending
    std::vector<Box> boxes;                         // of the bounded ones, in their order

    explicit SortedPrimitives(const Scene& scene);

    /// The one that a box is about. Absent: something else, or not at rest where it was made.
    std::optional<Triangle> triangle(std::uint32_t box) const { return all.triangle(bounded[box]); }

    /// The bounded primitives in an order of indices into `boxes`, each as often as it is named there.
    Primitives in_order(std::vector<std::uint32_t> order) const;
    Primitives without_bounds() const { return Primitives(all, unbounded); }
};

}  // namespace raylab
