// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_STACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_STACK_INL_H
#undef RAYLAB_BVH8_STACK_INL_H
#else
#define RAYLAB_BVH8_STACK_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/accelerator/bvh8/bvh8_places_of_ones.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// A child and the t at which the ray enters it, in one integer that is smaller for a nearer child: floats that are not
// negative have the same order as their bits. So three or four are sorted without branches that could be mispredicted.
class Waiting {
public:
    Waiting() = default;
    /// Nothing, which a ray enters before its end wherever that is: as a signed integer its entry is the least of all.
    static HWY_INLINE Waiting nothing() { return Waiting(std::numeric_limits<std::int32_t>::min(), Bvh8Child::none()); }
    HWY_INLINE Waiting(std::int32_t entry, Bvh8Child child)
        : key_(std::uint64_t{static_cast<std::uint32_t>(entry)} << 32 | std::bit_cast<std::uint32_t>(child)) {}
    HWY_INLINE Bvh8Child child() const { return std::bit_cast<Bvh8Child>(static_cast<std::uint32_t>(key_)); }
    /// Whether it is entered after a t, given as its bits.
    HWY_INLINE bool is_entered_after(std::int32_t latest) const {
        return static_cast<std::int64_t>(key_) >= std::int64_t{latest + 1} << 32;
    }
    friend HWY_INLINE bool operator<(Waiting a, Waiting b) { return a.key_ < b.key_; }

    // Swaps the two where necessary, so that a is the nearer. (By bits, because GCC makes branches of std::min and
    // std::max here, whose mispredictions take 2 % of a closest hit's time.)
    static HWY_INLINE void put_in_order(Waiting& a, Waiting& b) {
        const std::uint64_t swapped = (a.key_ ^ b.key_) & (0 - std::uint64_t{b.key_ < a.key_});
        a.key_ ^= swapped;
        b.key_ ^= swapped;
    }

private:
    std::uint64_t key_;
};

// Prefetches a node or a leaf.
class Prefetcher {
public:
    HWY_INLINE explicit Prefetcher(const Bvh8Nodes& tree)
        : addresses_(Bvh8Child::addresses(tree.nodes.data(), tree.leaves.data())) {}
    HWY_INLINE void prefetch(Bvh8Child child) const {
        const auto* const at = reinterpret_cast<const char*>(child.address(addresses_));
        for (std::size_t line = 0; line < 4; ++line) hwy::Prefetch(at + 64 * line);
    }

private:
    Bvh8Child::Addresses addresses_;
};

// The children that wait to be visited, the nearest on top, and below all of them none. (Their places are an array of
// their own, so that the top is kept in a register.)
class NearestFirst {
public:
    using Places = std::array<Waiting, Bvh8Nodes::max_waiting + 1>;
    HWY_INLINE NearestFirst(const Bvh8Nodes& tree, Places& places) : prefetcher_(tree), top_(places.data()) {
        push(Waiting::nothing());
    }

    // The nearest one, dropping those that the ray enters beyond its end.
    HWY_INLINE Bvh8Child pop(std::int32_t latest_entry) {
        do --top_;
        while (top_->is_entered_after(latest_entry));
        // (Read anew, as the four bytes it is: taken out of the eight that were compared, every node's name would be
        // extended to an address again.)
        const Waiting* nearest = top_;
        asm("" : "+r"(nearest));
        return nearest->child();
    }

    // Pushes the children that the ray hits (at least one), farthest first, and returns the nearest instead of pushing
    // it.
    HWY_INLINE Bvh8Child keep(const Bvh8Node& node, const std::int32_t* entries, std::uint32_t hit_found) {
        // Mostly one child is hit. Its place is then all that the next step waits for, not when it is entered.
        const auto first = static_cast<std::size_t>(std::countr_zero(hit_found));
        const Bvh8Child only = node.children[first];
        prefetcher_.prefetch(only);
        if ((hit_found & (hit_found - 1)) == 0) return only;
        Waiting a(entries[first], only);
        hit_found &= hit_found - 1;
        Waiting b = hit_first(node, entries, hit_found);
        if ((hit_found &= hit_found - 1) == 0) {
            // Of two, a branch chooses: rays that go alike choose alike, and the next step does not wait for this one's
            // entries. (Camera rays take 1 to 4 % less time, others the same.)
            if (a < b) [[likely]] {
                push(b);
                return a.child();
            }
            push(a);
            return b.child();
        }
        Waiting::put_in_order(a, b);
        Waiting c = hit_first(node, entries, hit_found);
        Waiting::put_in_order(b, c);
        Waiting::put_in_order(a, b);
        if ((hit_found &= hit_found - 1) == 0) {
            push(c);
            push(b);
            return a.child();
        }
        Waiting* const lowest = top_;
        push(c);
        push(b);
        push(a);
        for (; hit_found != 0; hit_found &= hit_found - 1) insert(lowest, hit_first(node, entries, hit_found));
        return (--top_)->child();
    }

private:
    // The first child that is hit. Its memory is prefetched while the others are examined and sorted.
    HWY_INLINE Waiting hit_first(const Bvh8Node& node, const std::int32_t* entries, std::uint32_t hit_found) const {
        const auto i = static_cast<std::size_t>(std::countr_zero(hit_found));
        const Bvh8Child child = node.children[i];
        prefetcher_.prefetch(child);
        return Waiting(entries[i], child);
    }

    HWY_INLINE void push(Waiting one) { *top_++ = one; }

    HWY_INLINE void insert(Waiting* lowest, Waiting one) {
        Waiting* at = top_++;
        for (; at != lowest && *(at - 1) < one; --at) *at = *(at - 1);
        *at = one;
    }

    Prefetcher prefetcher_;
    Waiting* top_;
};

// The children that wait to be visited in the order of their nodes, the last on top: where any hit will do, sorting
// saves no node, and its branches are mispredicted. Below all of them is none, twice, because what lies below the top
// is prefetched: a ray that is not stopped comes to it.
class InOrder {
public:
    using Places = std::array<Bvh8Child, Bvh8Nodes::max_waiting + 2 + bvh8_width>;  // whole vectors are stored
    HWY_INLINE InOrder(const Bvh8Nodes& tree, Places& places) : prefetcher_(tree), top_(places.data()) {
        *top_++ = Bvh8Child::none();
        *top_++ = Bvh8Child::none();
    }

    HWY_INLINE Bvh8Child pop(std::int32_t) {
        const Bvh8Child child = *--top_;
        prefetcher_.prefetch(top_[-1]);
        return child;
    }

    // Pushes the children that the ray hits (at least one) but the last, and returns that. There is no branch for each
    // child: those that are hit are moved together, and the top is moved by their number.
    HWY_INLINE Bvh8Child keep(const Bvh8Node& node, const std::int32_t*, std::uint32_t hit_found) {
        // (31 ^ is 31 -, and one instruction with the zeros' count.)
        const Bvh8Child last = node.children[static_cast<std::uint32_t>(31 ^ std::countl_zero(hit_found))];
        prefetcher_.prefetch(last);
        for (std::size_t i = 0; i < bvh8_width; i += lanes) {
            const auto bits = static_cast<std::uint8_t>(hit_found >> i & ((1u << lanes) - 1));
            const auto some = hn::Load(words, reinterpret_cast<const std::uint32_t*>(&node.children[i]));
            hn::StoreU(first_ones(some, bits), words, reinterpret_cast<std::uint32_t*>(top_));
            top_ += std::popcount(bits);
        }
        --top_;
        prefetcher_.prefetch(top_[-1]);
        return last;
    }

private:
    static constexpr hn::RebindToUnsigned<Lanes> words{};
    using Words = hn::Vec<hn::RebindToUnsigned<Lanes>>;

    // Those that have a bit, side by side.
    static HWY_INLINE Words first_ones(Words of, std::uint8_t bits) {
#if HWY_TARGET == HWY_AVX2
        // Highway 1.0.3's function does the same, but copies its table to the stack every time: a third of an any-hit
        // ray's time.
        constexpr hn::Rebind<std::uint8_t, decltype(words)> bytes;
        const auto places = hn::PromoteTo(words, hn::LoadU(bytes, bvh8_places_of_ones[bits].data()));
        return hn::TableLookupLanes(of, hn::IndicesFromVec(words, places));
#else
        return hn::CompressBits(of, &bits);
#endif
    }

    Prefetcher prefetcher_;
    Bvh8Child* top_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
