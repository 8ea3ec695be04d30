// Compiled once for every instruction set (see kd8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_KD8_STACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_KD8_STACK_INL_H
#undef RAYLAB_KD8_STACK_INL_H
#else
#define RAYLAB_KD8_STACK_INL_H
#endif

#include "raylab/accelerator/kd8/kd8_node.h"
#include "raylab/accelerator/kd8/kd8_planes-inl.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// What lies in a cell, and the range of t in which the ray is there.
struct VisitedCell {
    float entry, exit;
    Kd8Child child;

    VisitedCell() = default;  // without values, so that a stack of them is not cleared first
    HWY_INLINE VisitedCell(float from, float to, Kd8Child what) : entry(from), exit(to), child(what) {}
    HWY_INLINE VisitedCell(const Kd8Node& node, const Kd8Ranges& ranges, std::uint32_t hit_found) {
        const auto i = static_cast<std::size_t>(std::countr_zero(hit_found));
        *this = VisitedCell(ranges.entries[i], ranges.exits[i], node.children[i]);
    }
};

// The cells that wait to be visited, the nearest on top, and below all of them nothing.
class WaitingCells {
public:
    using Places = std::array<VisitedCell, Kd8Cells::max_waiting + 1>;
    HWY_INLINE WaitingCells(const Kd8Cells& cells, const Bvh8Nodes& contents, Places& places)
        : nodes_(reinterpret_cast<const char*>(cells.nodes.data())),
          lines_(reinterpret_cast<const char*>(contents.leaves.data())),
          top_(places.data()) {
        *top_++ = VisitedCell(-0.0f, 0, Kd8Child::none());  // as an integer, its entry is the least of all
    }

    // The nearest one, dropping those that the ray enters beyond its end.
    HWY_INLINE VisitedCell pop(std::int32_t latest_entry) {
        do --top_;
        while (std::bit_cast<std::int32_t>(top_->entry) > latest_entry);
        return *top_;
    }

    // Pushes the cells that the ray visits (at least one), farthest first, and returns the nearest instead of pushing
    // it. While that is visited, the others are prefetched.
    HWY_INLINE VisitedCell keep(const Kd8Node& node, const Kd8Ranges& ranges, std::uint32_t hit_found) {
        VisitedCell a(node, ranges, hit_found);
        if ((hit_found &= hit_found - 1) == 0) return a;
        VisitedCell b(node, ranges, hit_found);
        prefetch(b.child);
        if (b.entry < a.entry) std::swap(a, b);
        if ((hit_found &= hit_found - 1) == 0) {
            *top_++ = b;
            return a;
        }
        VisitedCell* const first = top_;
        *top_++ = b;
        *top_++ = a;
        for (; hit_found != 0; hit_found &= hit_found - 1) {
            const VisitedCell next(node, ranges, hit_found);
            prefetch(next.child);
            VisitedCell* place = top_++;
            for (; place > first && place[-1].entry < next.entry; --place) *place = place[-1];
            *place = next;
        }
        return *--top_;
    }

private:
    HWY_INLINE void prefetch(Kd8Child child) const {
        const char* at = child.is_node() ? nodes_ + child.node_offset() : lines_ + child.leaf().line_offset();
        for (std::size_t line = 0; line < 3; ++line) hwy::Prefetch(at + 64 * line);
    }

    const char *nodes_, *lines_;
    VisitedCell* top_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
