// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_STACK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_STACK_INL_H
#undef RAYLAB_BVH8_STACK_INL_H
#else
#define RAYLAB_BVH8_STACK_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_node.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// A child and the t at which the ray enters it, in one integer that is smaller for a nearer child: floats that are not
// negative have the same order as their bits. So a few of them are sorted without a branch that could be mispredicted.
class Waiting {
public:
    Waiting() = default;
    HWY_INLINE explicit Waiting(Bvh8Child child) : key_(std::bit_cast<std::uint32_t>(child)) {}
    HWY_INLINE Waiting(const Bvh8Node& node, const float* entries, std::uint32_t hit_found) {
        const auto i = static_cast<std::size_t>(std::countr_zero(hit_found));
        key_ = std::uint64_t{std::bit_cast<std::uint32_t>(entries[i])} << 32 |
               std::bit_cast<std::uint32_t>(node.children[i]);
    }
    HWY_INLINE Bvh8Child child() const { return std::bit_cast<Bvh8Child>(static_cast<std::uint32_t>(key_)); }
    HWY_INLINE float entry() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
    friend HWY_INLINE bool operator<(Waiting a, Waiting b) { return a.key_ < b.key_; }

    // Swaps the two where necessary, so that a is the nearer.
    static HWY_INLINE void put_in_order(Waiting& a, Waiting& b) {
        const std::uint64_t swapped = (a.key_ ^ b.key_) & (std::uint64_t{0} - std::uint64_t{b < a});
        a.key_ ^= swapped;
        b.key_ ^= swapped;
    }

private:
    std::uint64_t key_;
};

class Stack {
public:
    using Places = std::array<Waiting, Bvh8Nodes::max_depth*(bvh8_width - 1) + 1>;

    HWY_INLINE Stack(const Bvh8Nodes& tree, Places& places)
        : starts_{reinterpret_cast<const char*>(tree.nodes.data()), reinterpret_cast<const char*>(tree.leaves.data())},
          bottom_(places.data()),
          top_(bottom_) {}
    HWY_INLINE bool is_empty() const { return top_ == bottom_; }
    HWY_INLINE Waiting pop() { return *--top_; }

    // Pushes the children that the ray hits (at least one), farthest first, and returns the nearest instead of pushing
    // it.
    HWY_INLINE Bvh8Child keep(const Bvh8Node& node, const float* entries, std::uint32_t hit_found) {
        Waiting a = hit_first(node, entries, hit_found);
        if ((hit_found &= hit_found - 1) == 0) return a.child();
        Waiting b = hit_first(node, entries, hit_found);
        Waiting::put_in_order(a, b);
        if ((hit_found &= hit_found - 1) == 0) {
            push(b);
            return a.child();
        }
        Waiting c = hit_first(node, entries, hit_found);
        Waiting::put_in_order(b, c);
        Waiting::put_in_order(a, b);
        if ((hit_found &= hit_found - 1) == 0) {
            push(c);
            push(b);
            return a.child();
        }
        Waiting* const first = top_;
        push(c);
        push(b);
        push(a);
        for (; hit_found != 0; hit_found &= hit_found - 1) insert(first, hit_first(node, entries, hit_found));
        return pop().child();
    }

    // Pushes the children that the ray hits (at least one) but the last, which is returned, in the order of the node:
    // where any hit will do, sorting saves no node, and its branches are mispredicted.
    HWY_INLINE Bvh8Child keep_in_order(const Bvh8Node& node, std::uint32_t hit_found) {
        while (true) {
            const Bvh8Child child = node.children[static_cast<std::size_t>(std::countr_zero(hit_found))];
            prefetch(child);
            if ((hit_found &= hit_found - 1) == 0) return child;
            push(Waiting(child));
        }
    }

private:
    // The first child that is hit. Its memory is prefetched while the others are examined and sorted. (There is no
    // branch, because nodes and leaves alternate unpredictably.)
    HWY_INLINE Waiting hit_first(const Bvh8Node& node, const float* entries, std::uint32_t hit_found) const {
        const Waiting one(node, entries, hit_found);
        prefetch(one.child());
        return one;
    }
    HWY_INLINE void prefetch(Bvh8Child child) const {
        constexpr std::array<std::size_t, 2> sizes{sizeof(Bvh8Node), sizeof(Bvh8Line)};
        const std::size_t leaf = child.is_node() ? 0 : 1;
        const char* at = starts_[leaf] + sizes[leaf] * child.first();
        for (std::size_t line = 0; line < 4; ++line) hwy::Prefetch(at + 64 * line);
    }

    HWY_INLINE void push(Waiting one) { *top_++ = one; }

    HWY_INLINE void insert(Waiting* first, Waiting one) {
        Waiting* at = top_++;
        for (; at != first && *(at - 1) < one; --at) *at = *(at - 1);
        *at = one;
    }

    std::array<const char*, 2> starts_;
    Waiting *bottom_, *top_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
