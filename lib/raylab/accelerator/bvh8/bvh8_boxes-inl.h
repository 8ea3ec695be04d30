// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_BOXES_INL_H
#undef RAYLAB_BVH8_BOXES_INL_H
#else
#define RAYLAB_BVH8_BOXES_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_box_ray-inl.h"
#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"

#include <hwy/highway.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// The ray's numbers, in registers for tests against boxes, until the ray's end changes.
class BoxLanes {
public:
    HWY_INLINE BoxLanes(const Bvh8Nodes& tree, const BoxRay& ray, float start, float end)
        : start_(hn::BitCast(integers_tag, all(start))), end_(hn::BitCast(integers_tag, all(end))) {
        // (The compiler must not know that these are the same each time: it would keep copies of whole vectors on the
        // stack, and a ray's first node waits for them.)
        const BoxRay* of = &ray;
        asm volatile("" : "+r"(of));
        const auto* nodes = reinterpret_cast<const std::byte*>(tree.nodes.data());
#pragma GCC unroll 3
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::byte *near = nodes + of->rows->near[axis], *far = nodes + of->rows->far[axis];
            // (Nor that these begin alike: it would add their beginning to a node's place first, and a ray waits for
            // that at every step.)
            asm("" : "+r"(near));
            asm("" : "+r"(far));
            near_[axis] = near;
            far_[axis] = far;
            inverse_[axis] = all(of->inverse[axis]);
            near_start_[axis] = all(of->near_start[axis]);
            far_start_[axis] = all(of->far_start[axis]);
        }
    }

    // A mask of the node's boxes that the ray hits; the t at which it enters each is stored in `entries`, as its bits.
    // (No entry is sooner than the start, which is not negative, and an exit that is negative comes before it.)
    HWY_INLINE std::uint32_t hit_mask(std::size_t node, std::int32_t* HWY_RESTRICT entries) const {
        const auto row = [node](const std::byte* of_first)
                             HWY_ATTR { return reinterpret_cast<const float*>(of_first + node); };
        std::uint32_t hit_found = 0;
        for (std::size_t i = 0; i < bvh8_width; i += lanes) {
            const auto in = [&](std::size_t axis) HWY_ATTR {
                const Floats t = BoxRay::t_at(planes(row(near_[axis]) + i), near_start_[axis], inverse_[axis]);
                return hn::BitCast(integers_tag, t);
            };
            const auto out = [&](std::size_t axis) HWY_ATTR {
                const Floats t = BoxRay::t_at(planes(row(far_[axis]) + i), far_start_[axis], inverse_[axis]);
                return hn::BitCast(integers_tag, t);
            };
            const Integers entry = hn::Max(hn::Max(in(0), in(1)), hn::Max(in(2), start_));
            const Integers exit = hn::Min(hn::Min(out(0), out(1)), hn::Min(out(2), end_));
            hn::Store(entry, integers_tag, entries + i);
            hit_found |= signs(is_less(entry, hn::Add(exit, hn::Load(integers_tag, beyond_slack)))) << i;
        }
        return hit_found;
    }

private:
    // (Read before they are multiplied: GCC would read and multiply at once, and copy the inverse first, because that
    // is overwritten. Both are as many operations of a processor, but for the copy: 1 % of a ray's time.)
    static HWY_INLINE Floats planes(const float* row) {
        Floats read = hn::Load(lanes_tag, row);
#if HWY_TARGET <= HWY_AVX2
        asm("" : "+v"(read.raw));
#endif
        return read;
    }

    alignas(32) static constexpr std::int32_t beyond_slack[] = {  // in memory, so that it takes no register
        BoxRay::slack + 1, BoxRay::slack + 1, BoxRay::slack + 1, BoxRay::slack + 1,
        BoxRay::slack + 1, BoxRay::slack + 1, BoxRay::slack + 1, BoxRay::slack + 1};
    static_assert(std::size(beyond_slack) == bvh8_width);

    // Where the planes of the first node stand that the ray meets first on each axis, and those that it meets last.
    const std::byte *near_[3], *far_[3];
    Floats near_start_[3], far_start_[3], inverse_[3];
    Integers start_, end_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
