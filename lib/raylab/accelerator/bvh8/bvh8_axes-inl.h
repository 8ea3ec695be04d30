// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_AXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_AXES_INL_H
#undef RAYLAB_BVH8_AXES_INL_H
#else
#define RAYLAB_BVH8_AXES_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// One number for each axis: in one vector register, or in several where the instruction set has no such vectors. The
// fourth number is not used.
class Axes {
public:
    HWY_INLINE explicit Axes(const float* from) {
        for (std::size_t i = 0; i < parts; ++i) part_[i] = hn::LoadU(tag, from + i * part_lanes);
    }
    HWY_INLINE explicit Axes(float x) {
        for (std::size_t i = 0; i < parts; ++i) part_[i] = number(x);
    }
    HWY_INLINE void store(float* to) const {
        for (std::size_t i = 0; i < parts; ++i) hn::StoreU(part_[i], tag, to + i * part_lanes);
    }

    // Applies f to the numbers of each axis.
    template <class F, class... Others>
    HWY_INLINE Axes with(const F& f, const Others&... others) const {
        Axes result;
        for (std::size_t i = 0; i < parts; ++i) result.part_[i] = f(part_[i], others.part_[i]...);
        return result;
    }
    // A mask with a bit for each axis for which the test holds.
    template <class F, class... Others>
    HWY_INLINE std::uint32_t where(const F& test, const Others&... others) const {
        std::uint32_t found = 0;
        for (std::size_t i = 0; i < parts; ++i)
            found |= bits(tag, test(part_[i], others.part_[i]...)) << i * part_lanes;
        return found & 7;
    }
    // The numbers in the order of the given axes.
    HWY_INLINE Axes in_order(const std::int32_t* axes) const {
        Axes result;
        if constexpr (parts == 1) {
            result.part_[0] = hn::TableLookupLanes(part_[0], hn::SetTableIndices(tag, axes));
        } else {
            for (std::size_t i = 0; i < parts; ++i) result.part_[i] = part_[static_cast<std::size_t>(axes[i])];
        }
        return result;
    }

    static constexpr hn::CappedTag<float, 4> tag{};
    using AxisLanes = hn::Vec<hn::CappedTag<float, 4>>;
    static HWY_INLINE AxisLanes number(float x) { return hn::Set(tag, x); }
    // By the sign alone: -0 is negative. (As integers, which takes one instruction.)
    static HWY_INLINE auto is_negative(AxisLanes x) {
        return hn::RebindMask(tag, hn::Lt(hn::BitCast(integers, x), hn::Zero(integers)));
    }

private:
    static constexpr hn::RebindToSigned<hn::CappedTag<float, 4>> integers{};
    Axes() = default;
    static constexpr std::size_t part_lanes = hn::MaxLanes(tag), parts = 4 / part_lanes;
    AxisLanes part_[parts];
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
