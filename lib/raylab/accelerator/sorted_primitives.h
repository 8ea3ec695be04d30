#pragma once

#include "raylab/accelerator/primitives.h"

#include <cstdint>
#include <vector>

namespace raylab {

/// A scene's primitives as a structure takes them in: those with bounds, which it sorts, and those without (planes), which
/// every ray is tested against.
struct SortedPrimitives {
    Primitives all;                        // in scene order
    std::vector<std::uint32_t> bounded, unbounded;  // places in `all`, ascending
    std::vector<Box> boxes;                // of the bounded ones, in their order

    explicit SortedPrimitives(const Scene& scene);

    /// The bounded ones in an order of `boxes`' indices (each as often as it stands there), and the unbounded ones.
    Primitives in_order(std::vector<std::uint32_t> order) const;
    Primitives without_bounds() const { return Primitives(all, unbounded); }
};

}  // namespace raylab
