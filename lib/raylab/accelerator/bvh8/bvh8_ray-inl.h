// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_RAY_INL_H
#undef RAYLAB_BVH8_RAY_INL_H
#else
#define RAYLAB_BVH8_RAY_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_axes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/geometry/ray.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

constexpr float unit = unit_roundoff<float>;  // u
constexpr float spare = 1 + 0x1p-10f;         // makes up for the rounding of an error bound itself

// A ray prepared for tests of eight boxes, or eight triangles, at once, in floats.
//
// Boxes: a ray never misses one that it exactly hits. t = (plane - origin) / direction comes with the rounding of the
// inverse and those of two operations, or of one where the instruction set multiplies and subtracts at once: together
// less than 4 u |t|. The far planes' t, and the end of the ray (box_end), are made larger by more than twice that, by
// way of the inverse (Ize: Robust BVH Ray Traversal, JCGT 2(2), 2013), which is right where no t in the ray's range is
// negative. And for either plane the origin is moved outward, by 4 u of it and by 2^-100 at least. One operation takes
// the product origin / direction from outside, whose rounding is as if the origin were moved by another u of it; the
// moved origin's own rounding is one more. What is left of the move is at least 2^-101: divided by a direction of at
// most 2^40 that makes up for a t below 2^-126, whose rounding errs by 2^-150.
//
// Along an axis where the direction is zero it is taken as 2^-23 of the direction's largest component instead, and the
// origin is moved by 2^-21 of the largest coordinate m, too. Until the ray has left the tree it has moved by at most 2
// m along the largest component, so by 2^-22 m along this axis: it is still inside of every slab in which the ray is.
//
// Triangles: sheared along the ray's dominant axis (Woop, Benthin & Wald: Watertight Ray/Triangle Intersection, JCGT
// 2(1), 2013) a triangle is hit where the three areas about the origin have one sign. A bound of their rounding errors,
// whose part that depends on the ray alone is computed once, tells which signs are certain: see bvh8_triangles-inl.h.
class Bvh8Ray {
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

    /// Of no triangle or box that a ray within the displacement hits, on each axis, it is said that it is missed. Its
    /// rounding, 2 u of the origin, is part of the displacement.
    HWY_INLINE Bvh8Ray(const Ray& ray, const Bvh8Nodes& tree, double last, float displacement) : start(ray.range.min) {
        const Axes o(&ray.origin.x), d(&ray.direction.x);
        const std::uint32_t still = d.where([](AxisLanes x) HWY_ATTR { return hn::Eq(x, hn::Zero(Axes::tag)); });
        fits_floats = start >= 0 && is_moderate(o, d) && still != 7 && !tree.is_far;
        axes = in_turn[dominant(d)];
        displacement = std::max(displacement, 0x1p-100f);
        if (still == 0) [[likely]] {
            set_boxes(o, d, Axes(displacement));
        } else {
            const Moving moving = moving_along(still, ray, tree, displacement);
            set_boxes(o, Axes(moving.direction.data()), Axes(moving.displacement.data()));
        }
        end_by(last);
    }

    // Prepares the ray for triangles; many rays never reach one.
    HWY_INLINE void prepare_for_triangles(const Ray& ray, const Bvh8Nodes& tree, float displacement) {
        if (!is_sheared_) set_shear(Axes(&ray.origin.x), Axes(&ray.direction.x), tree, displacement);
    }

    // Whether floats suffice: no coordinate beyond 2^39, each component of the direction between 2^-60 and 2^40 or zero
    // but not all zero, no negative t. Then nothing overflows: areas are below 2^84, volumes below 2^126.
    bool fits_floats;

    // Where in a node the planes of each axis begin that the ray meets first, and those that it meets last, in bytes.
    struct Rows {
        std::array<std::uint8_t, 3> near, far;
    };
    const Rows* rows;
    float near_start[4], far_start[4];  // of the origin, moved outward: see plane_start()
    float near_inverse[4], far_inverse[4];
    float start, end = largest_float;  // the range of t: hits of triangles are compared with `end`,
    float box_end = largest_float;     // entries of boxes with `box_end`

    const std::int32_t* axes;  // the two axes to which triangles are sheared, and the dominant one
    float origin[4];           // along those axes
    float shear[4];            // the direction along the first two, divided by that along the dominant one
    float slowness;            // 1 / direction along the dominant one, with its sign
    // The error bound of a triangle's t is constant + linear r, where r is its reach in depth: see Sure.
    float t_error_constant, t_error_linear;
    static constexpr float underflow = 0x1p-80f;  // of depths
    // The error bound of an area is constant + r (linear + quadratic r), where r is the largest sheared coordinate of
    // the triangle.
    float error_constant, error_linear;
    static constexpr float error_quadratic = 4 * unit * spare;

    // Ends the ray at t. The end is t, if it is a float as it mostly is, or the next float above it, because a range
    // includes its end. It stays finite, so that a box at infinity is not visited.
    HWY_INLINE void end_by(double t) {
        if (!(t < end)) return;
        if (t < -largest_float) t = -largest_float;
        const auto rounded = static_cast<float>(t);
        end_by(rounded < t ? std::nextafter(rounded, largest_float) : rounded);
    }
    HWY_INLINE void end_by(float t) {
        end = t;
        box_end = t * (1 + 8 * unit);
    }

private:
    bool is_sheared_ = false;
    static constexpr float largest_float = std::numeric_limits<float>::max();
    static constexpr float flattest = 0x1p-60f, steepest = 0x1p40f;
    using AxisLanes = Axes::AxisLanes;

    // Whether the numbers are as large and small as floats suffice for.
    static HWY_INLINE bool is_moderate(const Axes& o, const Axes& d) {
        return o.where(
                   [](AxisLanes at, AxisLanes along) HWY_ATTR {
                       const AxisLanes far = hn::Abs(at), steep = hn::Abs(along);
                       const auto is_still = hn::Eq(along, hn::Zero(Axes::tag));
                       return hn::And(hn::And(hn::Le(far, Axes::number(Bvh8Nodes::farthest)),
                                              hn::Le(steep, Axes::number(steepest))),
                                      hn::Or(is_still, hn::Ge(steep, Axes::number(flattest))));
                   },
                   d) == 7;
    }

    // The ray for boxes where it stands still along some axes. (It is a function of its own that is called with copies,
    // so that other rays keep their numbers in registers.)
    struct Moving {
        std::array<float, 4> direction, displacement;
    };
    static HWY_NOINLINE Moving moving_along(std::uint32_t still, const Ray& ray, const Bvh8Nodes& tree,
                                            float displacement) {
        const Vec3f &o = ray.origin, &d = ray.direction;
        const float steepest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        const float farthest = std::max({tree.reach, std::abs(o.x), std::abs(o.y), std::abs(o.z)});
        Moving moving{{d.x, d.y, d.z, 1}, {displacement, displacement, displacement, 0}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if ((still >> axis & 1) == 0) continue;
            moving.direction[axis] = steepest * 0x1p-23f;
            moving.displacement[axis] += farthest * 0x1p-21f;
        }
        return moving;
    }

    HWY_INLINE void set_boxes(const Axes& o, const Axes& d, const Axes& displacement) {
        const Axes inverse = d.with([](AxisLanes x) HWY_ATTR { return hn::Div(Axes::number(1), x); });
        const Axes outward = o.with(
            [](AxisLanes x, AxisLanes moved, AxisLanes i) HWY_ATTR {
                const AxisLanes rounding = hn::Mul(hn::Abs(x), Axes::number(4 * unit));
                return hn::CopySignToAbs(hn::Mul(hn::Add(rounding, moved), Axes::number(spare)), i);
            },
            displacement, inverse);
        const Axes inverse_of_far =
            inverse.with([](AxisLanes x) HWY_ATTR { return hn::Mul(x, Axes::number(1 + 12 * unit)); });
        o.with([](AxisLanes x, AxisLanes by, AxisLanes i) HWY_ATTR { return plane_start(hn::Add(x, by), i); }, outward,
               inverse)
            .store(near_start);
        o.with([](AxisLanes x, AxisLanes by, AxisLanes i) HWY_ATTR { return plane_start(hn::Sub(x, by), i); }, outward,
               inverse_of_far)
            .store(far_start);
        inverse.store(near_inverse);
        inverse_of_far.store(far_inverse);
        rows = &rows_of[d.where([](AxisLanes x) HWY_ATTR { return hn::Lt(x, hn::Zero(Axes::tag)); })];
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

    HWY_INLINE void set_shear(const Axes& o, const Axes& d, const Bvh8Nodes& tree, float displacement) {
        is_sheared_ = true;
        o.in_order(axes).store(origin);
        slowness = near_inverse[axes[2]];
        d.in_order(axes).with([&](AxisLanes x) HWY_ATTR { return hn::Mul(x, Axes::number(slowness)); }).store(shear);
        t_error_constant = std::abs(slowness) * (underflow + 3 * spare * displacement);
        t_error_linear = std::abs(slowness) * (6 * unit * spare);

        float reach[4];  // at least the distance of any corner from the origin, on each axis
        const auto farther = [](AxisLanes x, AxisLanes p, AxisLanes q)
                                 HWY_ATTR { return hn::Max(hn::Abs(hn::Sub(p, x)), hn::Abs(hn::Sub(q, x))); };
        o.with(farther, Axes(tree.min_corner.data()), Axes(tree.largest_corner.data())).in_order(axes).store(reach);
        // x' = (a_x - o_x) - s (a_z - o_z) has one rounding of the first term, four of the second (s has two), one of
        // x'. The bound is for both axes together; the shears are at most one, except for rounding. A displaced ray
        // sees the triangle displaced: by as much on each axis, and by as much again through the shear.
        const float error =
            unit * spare * (2 * (reach[0] + reach[1]) + 10 * reach[2]) + std::max(4 * spare * displacement, 0x1p-139f);
        // U = c_x b_y - c_y b_x: each coordinate errs by up to e_x or e_y and is no larger than r, each product and the
        // difference is rounded: 2 r (e_x + e_y) + 2 e_x e_y + 4 u r^2.
        error_linear = 2 * error * spare;
        error_constant = error * error * spare + 0x1p-140f;
    }

    // The axis along which the direction is steepest, the first of equal ones. (A table replaces branches that would be
    // mispredicted for every third ray.)
    static HWY_INLINE std::size_t dominant(const Axes& d) {
        const Axes steep = d.with([](AxisLanes x) HWY_ATTR { return hn::Abs(x); });
        const std::uint32_t no_flatter = steep.in_order(xyx).where(
            [](AxisLanes p, AxisLanes q) HWY_ATTR { return hn::Ge(p, q); }, steep.in_order(yzz));
        // x >= y adds one, y >= z two, x >= z four.
        static constexpr std::array<std::uint8_t, 8> steepest_of{2, 2, 1, 2, 2, 0, 1, 0};
        return steepest_of[no_flatter];
    }
    alignas(16) static constexpr std::int32_t xyx[4] = {0, 1, 0, 3}, yzz[4] = {1, 2, 2, 3};

    // For each dominant axis, the two axes that follow it, and itself.
    alignas(16) static constexpr std::int32_t in_turn[3][4] = {{1, 2, 0, 3}, {2, 0, 1, 3}, {0, 1, 2, 3}};
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
