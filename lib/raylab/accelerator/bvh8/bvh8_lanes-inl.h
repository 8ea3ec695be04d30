// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_LANES_INL_H
#undef RAYLAB_BVH8_LANES_INL_H
#else
#define RAYLAB_BVH8_LANES_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_node.h"

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A vector of eight floats, or of as many as the instruction set has.
using Lanes = hn::CappedTag<float, bvh8_width>;
constexpr Lanes lanes_tag;
constexpr std::size_t lanes = hn::MaxLanes(lanes_tag);
using Floats = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;

// The bits of as many floats. Those of floats that are not negative have their order, and come after all others: so a
// larger one is known after one cycle, where Intel's processors take four for floats.
constexpr hn::RebindToSigned<Lanes> integers_tag;
using Integers = hn::Vec<hn::RebindToSigned<Lanes>>;

HWY_INLINE Floats all(float x) { return hn::Set(lanes_tag, x); }

template <class Tag, class SomeMask>
HWY_INLINE std::uint32_t bits(Tag tag, SomeMask mask) {
    std::array<std::uint8_t, 8> bytes{};
    hn::StoreMaskBits(tag, mask, bytes.data());
    return bytes[0];
}
#if HWY_TARGET == HWY_AVX2  // One instruction, after whose eight bits GCC knows of no others.
HWY_INLINE std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm256_movemask_ps(mask.raw)); }
#else
HWY_INLINE std::uint32_t bits(Mask mask) { return bits(lanes_tag, mask); }
#endif

// A mask of those that are negative; -1 where a is the smaller and 0 elsewhere. (Not AVX-512's masks, which Intel's
// processors take two cycles longer for.)
#if HWY_TARGET <= HWY_AVX2
HWY_INLINE std::uint32_t signs(Floats x) { return static_cast<std::uint32_t>(_mm256_movemask_ps(x.raw)); }
HWY_INLINE Integers is_less(Integers a, Integers b) { return Integers{_mm256_cmpgt_epi32(b.raw, a.raw)}; }
#else
HWY_INLINE std::uint32_t signs(Floats x) {
    return bits(hn::RebindMask(lanes_tag, hn::Lt(hn::BitCast(integers_tag, x), hn::Zero(integers_tag))));
}
HWY_INLINE Integers is_less(Integers a, Integers b) { return hn::VecFromMask(integers_tag, hn::Lt(a, b)); }
#endif
HWY_INLINE std::uint32_t signs(Integers x) { return signs(hn::BitCast(lanes_tag, x)); }

// The same for floats of which one at least is not negative, nor -0, and none is a NaN.
HWY_INLINE Integers is_less(Floats a, Floats b) {
    return is_less(hn::BitCast(integers_tag, a), hn::BitCast(integers_tag, b));
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
