// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_RAY_INL_H
#undef RAYLAB_BVH8_RAY_INL_H
#else
#define RAYLAB_BVH8_RAY_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_axes-inl.h"
#include "raylab/accelerator/bvh8/bvh8_box_ray-inl.h"
#include "raylab/accelerator/bvh8/bvh8_node.h"
#include "raylab/geometry/ray.h"

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// A ray's range of t, and the ray prepared for tests of eight triangles at once, in floats.
//
// Sheared along the ray's dominant axis (Woop, Benthin & Wald: Watertight Ray/Triangle Intersection, JCGT 2(1), 2013) a
// triangle is hit where the three areas about the origin have one sign. A bound of their rounding errors,
// whose part that depends on the ray alone is computed once, tells which signs are certain: see bvh8_triangles-inl.h.
class Bvh8Ray {
public:
    HWY_INLINE Bvh8Ray(const Ray& ray, const BoxRay& for_boxes, double last)
        : boxes(for_boxes), start(ray.range.min + 0.0f) {
        axes = axes_of(Axes(&ray.direction.x));
        end_by(last);
    }

    // Prepares the ray for triangles; many rays never reach one. No triangle is missed that a ray hits which on each
    // axis is within the displacement.
    HWY_INLINE void prepare_for_triangles(const Ray& ray, const Bvh8Nodes& tree, float displacement) {
        if (!is_sheared_) set_shear(Axes(&ray.origin.x), Axes(&ray.direction.x), tree, displacement);
    }

    const BoxRay& boxes;               // the ray for tests of boxes
    float start, end = largest_float;  // the range of t; neither is -0, which as an integer would come before each t

    const std::int32_t* axes;  // the two axes to which triangles are sheared, and the dominant one
    float origin[4];           // along those axes
    float shear[4];            // the direction along the first two, divided by that along the dominant one
    float slowness;            // 1 / direction along the dominant one, with its sign
    // The error bound of a triangle's depth is least_depth_error + depth_error r, where r is its reach in depth: see
    // Sure.
    float least_depth_error;
    static constexpr float depth_error = 6 * unit * spare;
    static constexpr float underflow = 0x1p-80f;  // of depths
    // The error bound of an area is r (linear + quadratic r), where r is the largest sheared coordinate of the
    // triangle, or `linear` if that is larger; and Areas::least_error.
    float error_linear;
    static constexpr float error_quadratic = 12 * unit * spare;

    // Ends the ray at t. The end is t, if it is a float as it mostly is, or the next float above it, because a range
    // includes its end. (0 is added, so that it is not -0.)
    HWY_INLINE void end_by(double t) {
        if (!(t < end)) return;
        if (t < -largest_float) t = -largest_float;
        const auto rounded = static_cast<float>(t);
        end = (rounded < t ? std::nextafter(rounded, largest_float) : rounded) + 0.0f;
    }

    // The largest t at which a box that is visited may be entered, as bits.
    HWY_INLINE std::int32_t latest_entry() const { return std::bit_cast<std::int32_t>(end) + BoxRay::slack; }

private:
    bool is_sheared_ = false;
    static constexpr float largest_float = std::numeric_limits<float>::max();
    using AxisLanes = Axes::AxisLanes;

    HWY_INLINE void set_shear(const Axes& o, const Axes& d, const Bvh8Nodes& tree, float displacement) {
        is_sheared_ = true;
        o.in_order(axes).store(origin);
        const auto dominant_axis = static_cast<std::size_t>(axes[2]);
        slowness = boxes.inverse[dominant_axis];
        d.in_order(axes).with([&](AxisLanes x) HWY_ATTR { return hn::Mul(x, Axes::number(slowness)); }).store(shear);
        least_depth_error = underflow + 3 * spare * displacement;

        // x' = (a_x - o_x) - s (a_z - o_z) has one rounding of the first term, four of the second (s has two), one of
        // x'. With r as below and z the depth, the first term is no larger than r + |s| z: together 2 u r + 5 u |s| z.
        // A displaced ray sees the triangle displaced: by as much on each axis, and by as much again through the shear,
        // which is at most one.
        //
        // U = c_x b_y - c_y b_x: each coordinate errs by up to e_x or e_y and is no larger than r, each product and the
        // difference is rounded: 2 r (e_x + e_y) + 2 e_x e_y + 4 u r^2. With E the part of e_x + e_y that does not
        // depend on r that is 2 r E + E^2 / 2 + 12 u r^2. Where r is at least 2.3 E, or is taken as that, 2.3 r E
        // suffices for the first two, with .19 E^2 to spare.
        const float ahead = std::abs(origin[2] - tree.center[dominant_axis]) + tree.half_size[dominant_axis];
        const float all_shear = std::abs(shear[0]) + std::abs(shear[1]);
        constexpr float several = 2.3f * spare;
        error_linear = ahead * all_shear * (several * 5 * unit * spare) + (several * 4 * displacement + 0x1p-70f);
    }

    // The axis along which the direction is steepest, behind the two that follow it. (A table replaces branches that
    // would be mispredicted for every third ray.)
    static HWY_INLINE const std::int32_t* axes_of(const Axes& d) {
        const Axes steep = d.with([](AxisLanes x) HWY_ATTR { return hn::Abs(x); });
        const std::uint32_t no_flatter =
            steep.where([](AxisLanes p, AxisLanes q) HWY_ATTR { return hn::Ge(p, q); }, steep.in_order(after_x));
        // x >= y adds one, y >= z two, z >= x four.
        static constexpr auto &x = after_x, &y = after_y, &z = after_z;
        static constexpr const std::int32_t* of[8] = {z, x, y, x, z, z, y, x};
        return of[no_flatter];
    }
    alignas(16) static constexpr std::int32_t after_x[4] = {1, 2, 0, 3}, after_y[4] = {2, 0, 1, 3},
                                              after_z[4] = {0, 1, 2, 3};
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
