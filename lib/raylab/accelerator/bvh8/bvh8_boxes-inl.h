// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_BOXES_INL_H
#undef RAYLAB_BVH8_BOXES_INL_H
#else
#define RAYLAB_BVH8_BOXES_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_ray-inl.h"

#include <hwy/highway.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// The ray's numbers, broadcast to registers for tests against boxes.
struct BoxLanes {
    std::array<const std::byte*, 3> near_row, far_row;  // of the first node
    Floats near_start[3], far_start[3], near_inverse[3], far_inverse[3], start;

    HWY_INLINE BoxLanes(const Bvh8Nodes& tree, const Bvh8Ray& ray) : start(all(ray.start)) {
        const auto* nodes = reinterpret_cast<const std::byte*>(tree.nodes.data());
#pragma GCC unroll 3
        for (std::size_t axis = 0; axis < 3; ++axis) {
            near_row[axis] = nodes + ray.rows->near[axis];
            far_row[axis] = nodes + ray.rows->far[axis];
            // (The compiler must not know that these begin alike: it would add their beginning to a node's place first,
            // and a ray waits for that at every step.)
            asm("" : "+r"(near_row[axis]));
            asm("" : "+r"(far_row[axis]));
            near_inverse[axis] = all(ray.near_inverse[axis]);
            far_inverse[axis] = all(ray.far_inverse[axis]);
            near_start[axis] = all(ray.near_start[axis]);
            far_start[axis] = all(ray.far_start[axis]);
        }
    }

    // A mask of the node's boxes that the ray hits; the t at which it enters each is stored in `entries`.
    HWY_INLINE std::uint32_t hit_mask(std::size_t node, float end, float* HWY_RESTRICT entries) const {
        const auto row = [node](const std::byte* of_first)
                             HWY_ATTR { return reinterpret_cast<const float*>(of_first + node); };
        std::uint32_t hit_found = 0;
        for (std::size_t i = 0; i < bvh8_width; i += lanes) {
            const auto in = [&](std::size_t axis) HWY_ATTR {
                return Bvh8Ray::t_at(hn::Load(lanes_tag, row(near_row[axis]) + i), near_start[axis],
                                     near_inverse[axis]);
            };
            const auto out = [&](std::size_t axis) HWY_ATTR {
                return Bvh8Ray::t_at(hn::Load(lanes_tag, row(far_row[axis]) + i), far_start[axis], far_inverse[axis]);
            };
            const Floats entry = hn::Max(hn::Max(in(0), in(1)), hn::Max(in(2), start));
            const Floats exit = hn::Min(hn::Min(out(0), out(1)), hn::Min(out(2), all(end)));
            hn::Store(entry, lanes_tag, entries + i);
            hit_found |= bits(hn::Le(entry, exit)) << i;
        }
        return hit_found;
    }
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
