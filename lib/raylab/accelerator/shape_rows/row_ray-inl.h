// Compiled once for every instruction set (see row_questions.cpp): a guard that opens again for the next.
#if defined(RAYLAB_ROW_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_ROW_RAY_INL_H
#undef RAYLAB_ROW_RAY_INL_H
#else
#define RAYLAB_ROW_RAY_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/accelerator/shape_rows/shape_rows.h"

#include <hwy/highway.h>

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// Four doubles of a row at once, or as many of them as there are. (Eight were slower on Sapphire Rapids, and 5 % faster
// on Zen 4 for a scene of 18 shapes.)
using DoublesTag = hn::CappedTag<double, 4>;
constexpr DoublesTag doubles_tag;
constexpr std::size_t doubles_at_once = hn::MaxLanes(doubles_tag);
static_assert(ShapeRows::largest % doubles_at_once == 0);
using Doubles = hn::Vec<DoublesTag>;
using Bools = hn::Mask<DoublesTag>;

HWY_INLINE Doubles number(double x) { return hn::Set(doubles_tag, x); }

HWY_INLINE Doubles load(const ShapeRows::Row& row, std::size_t i) { return hn::Load(doubles_tag, row.data() + i); }

HWY_INLINE Doubles dot(Doubles x, Doubles y, Doubles z, Doubles p, Doubles q, Doubles r) {
    return hn::Add(hn::Add(hn::Mul(x, p), hn::Mul(y, q)), hn::Mul(z, r));
}

// A ray as registers hold it. It is read number by number: it has just been written so, and what was stored in pieces
// is not soon loaded as a whole. For the same reason nothing here is a structure of vectors that might be copied.
struct RowRay {
    HWY_INLINE explicit RowRay(const Ray& ray)
        : ox(number(ray.origin.x)),
          oy(number(ray.origin.y)),
          oz(number(ray.origin.z)),
          dx(number(ray.direction.x)),
          dy(number(ray.direction.y)),
          dz(number(ray.direction.z)) {}
    RowRay(const RowRay&) = delete;
    RowRay& operator=(const RowRay&) = delete;

    const Doubles ox, oy, oz, dx, dy, dz;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
