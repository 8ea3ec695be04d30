// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_BOX_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_BOX_RAY_INL_H
#undef RAYLAB_BVH8_BOX_RAY_INL_H
#else
#define RAYLAB_BVH8_BOX_RAY_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_axes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/geometry/ray.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

constexpr float unit = unit_roundoff<float>;  // u
constexpr float spare = 1 + 0x1p-10f;         // makes up for the rounding of an error bound itself

// A ray prepared for tests of eight boxes at once, in floats: it never misses one that it exactly hits.
//
// t = (plane - origin) / direction comes with the rounding of the inverse and those of two operations, or of one where
// the instruction set multiplies and subtracts at once: together less than 4 u |t|. So a box is hit where the latest
// entry comes before the first exit, or after it by 8 u |t| and what that leaves out, u^2 |t|: `slack` takes nine units
// in the last place for it, of which each is u |t| at least. (Ize: Robust BVH Ray Traversal, JCGT 2(2), 2013, widens
// the far planes' inverses instead, which takes three vectors more.) That is right where no t in the ray's range is
// negative. And for either plane the origin is moved outward, by 4 u of it and by 2^-100 at least. One operation takes
// the product origin / direction from outside, whose rounding is as if the origin were moved by another u of it; the
// moved origin's own rounding is one more. What is left of the move is at least 2^-101: divided by a direction of at
// most 2^40 that makes up for a t below 2^-126, whose rounding errs by 2^-150.
//
// Along an axis where the direction is zero it is taken as 2^-23 of the direction's largest component instead, and the
// origin is moved by 2^-21 of the largest coordinate m, too. Until the ray has left the tree it has moved by at most 2
// m along the largest component, so by 2^-22 m along this axis: it is still inside of every slab in which the ray is.
class BoxRay {
public:
    // The t of a plane, (plane - origin) inverse. Where the instruction set multiplies and subtracts at once, it is
    // plane inverse - origin inverse with one rounding for both: each node's test waits two cycles less, which brings
    // 3 % more rays a second.
#if HWY_NATIVE_FMA
    template <class V>
    static HWY_INLINE V plane_start(V origin, V inverse) {
        return hn::Mul(origin, inverse);
    }
    template <class V>
    static HWY_INLINE V t_at(V plane, V start, V inverse) {
        return hn::MulSub(plane, inverse, start);
    }
#else
    template <class V>
    static HWY_INLINE V plane_start(V origin, V) {
        return origin;
    }
    template <class V>
    static HWY_INLINE V t_at(V plane, V start, V inverse) {
        return hn::Mul(hn::Sub(plane, start), inverse);
    }
#endif

    /// No box is missed that a ray hits which on each axis is within the displacement. Its rounding, 2 u of the origin,
    /// is part of the displacement.
    HWY_INLINE BoxRay(const Ray& ray, const Bvh8Nodes& tree, float displacement) {
        const Axes o(&ray.origin.x), d(&ray.direction.x);
        displacement = std::max(displacement, least_displacement) * spare;
        const bool starts_ahead = ray.range.min >= 0;
        fits_floats = starts_ahead && is_moderate(o, d, tree);
        if (fits_floats) [[likely]] {
            set(o, d, Axes(displacement));
        } else if (starts_ahead) {  // it may stand still along an axis
            const Moving moving = moving_along(ray, tree, displacement);
            const Axes moved(moving.direction.data());
            fits_floats = is_moderate(o, moved, tree);
            set(o, moved, Axes(moving.displacement.data()));
        }
    }

    // Whether floats suffice: no coordinate beyond 2^39, each component of the direction, or what is taken for one that
    // is zero, between 2^-60 and 2^40, no negative t. Then nothing overflows: areas are below 2^84, volumes below
    // 2^126. Where they do not, nothing else counts.
    bool fits_floats;

    // Where in a node the planes of each axis begin that the ray meets first, and those that it meets last, in bytes.
    struct alignas(8) Rows {
        std::array<std::uint8_t, 3> near, far;
    };
    const Rows* rows;
    alignas(16) float near_start[4], far_start[4];  // of the origin, moved outward: see plane_start()
    alignas(16) float inverse[4];                   // of the direction

    // How far beyond the first exit a box's latest entry may be, in units in the last place. (Floats that are not
    // negative have the order of their bits as integers, and the next one's bits are one more.)
    static constexpr std::int32_t slack = 9;

private:
    static constexpr float flattest = 0x1p-60f, steepest = 0x1p40f, least_displacement = 0x1p-100f;
    using AxisLanes = Axes::AxisLanes;

    // Whether the numbers are as large and small as floats suffice for.
    static HWY_INLINE bool is_moderate(const Axes& o, const Axes& d, const Bvh8Nodes& tree) {
        return o.where(
                   [&](AxisLanes at, AxisLanes along) HWY_ATTR {
                       const AxisLanes steep = hn::Abs(along);
                       return hn::And(
                           hn::Le(hn::Abs(at), Axes::number(tree.farthest_origin)),
                           hn::And(hn::Ge(steep, Axes::number(flattest)), hn::Le(steep, Axes::number(steepest))));
                   },
                   d) == 7;
    }

    // The ray for boxes where it stands still along some axes. (It is a function of its own that is called with copies,
    // so that other rays keep their numbers in registers.)
    struct Moving {
        std::array<float, 4> direction, displacement;
    };
    static HWY_NOINLINE Moving moving_along(const Ray& ray, const Bvh8Nodes& tree, float displacement) {
        const Vec3f &o = ray.origin, &d = ray.direction;
        const float steepest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        const float farthest = std::max({tree.reach, std::abs(o.x), std::abs(o.y), std::abs(o.z)});
        Moving moving{{d.x, d.y, d.z, 1}, {displacement, displacement, displacement, 0}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (moving.direction[axis] != 0) continue;
            moving.direction[axis] = steepest * 0x1p-23f;
            moving.displacement[axis] += farthest * (0x1p-21f * spare);
        }
        return moving;
    }

    HWY_INLINE void set(const Axes& o, const Axes& d, const Axes& displacement) {
        const Axes by = d.with([](AxisLanes x) HWY_ATTR { return hn::Div(Axes::number(1), x); });
        const Axes outward = o.with(
            [](AxisLanes x, AxisLanes moved, AxisLanes i) HWY_ATTR {
                return hn::CopySignToAbs(hn::MulAdd(hn::Abs(x), Axes::number(4 * unit * spare), moved), i);
            },
            displacement, by);
        const auto nearer = [](AxisLanes x, AxisLanes moved, AxisLanes i)
                                HWY_ATTR { return plane_start(hn::Add(x, moved), i); };
        const auto farther = [](AxisLanes x, AxisLanes moved, AxisLanes i)
                                 HWY_ATTR { return plane_start(hn::Sub(x, moved), i); };
        o.with(nearer, outward, by).store(near_start);
        o.with(farther, outward, by).store(far_start);
        by.store(inverse);
        rows = &rows_of[d.where([](AxisLanes x) HWY_ATTR { return Axes::is_negative(x); })];
    }

    // By the axes along which the ray goes backward. (A table, because it is needed at once: computed it is 40
    // instructions.)
    static constexpr std::array<Rows, 8> rows_of = [] {
        constexpr std::size_t row = bvh8_width * sizeof(float);
        std::array<Rows, 8> all{};
        for (std::size_t backward = 0; backward < all.size(); ++backward)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t lower = row * axis, upper = row * (axis + 3);
                const bool swapped = (backward >> axis & 1) != 0;
                all[backward].near[axis] = static_cast<std::uint8_t>(swapped ? upper : lower);
                all[backward].far[axis] = static_cast<std::uint8_t>(swapped ? lower : upper);
            }
        return all;
    }();
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
