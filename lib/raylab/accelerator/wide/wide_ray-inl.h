// Compiled once for every instruction set (see wide_walk.cpp): a guard that opens again for the next.
#if defined(RAYLAB_WIDE_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_WIDE_RAY_INL_H
#undef RAYLAB_WIDE_RAY_INL_H
#else
#define RAYLAB_WIDE_RAY_INL_H
#endif

#include "raylab/accelerator/wide/wide_lanes-inl.h"
#include "raylab/accelerator/wide/wide_node.h"
#include "raylab/geometry/ray.h"

#include <hwy/highway.h>

#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

constexpr float unit = std::numeric_limits<float>::epsilon() / 2;  // u
constexpr float spare = 1 + 0x1p-10f;                              // for the roundings of a bound itself

// A ray prepared for eight boxes, or eight triangles, at once, in floats.
//
// Boxes: a ray never misses one that it exactly meets. t = (plane - origin) * (1 / direction) has three roundings: 4 u |t|.
// The far planes' t is made larger by twice that and a little more, by way of the inverse (Ize: Robust BVH Ray Traversal,
// JCGT 2(2), 2013), which is right where no t in the ray's range is negative. And the origin is moved outward by one float
// for either plane: that makes up for products that underflow, and a ray along an axis, whose direction is zero on the
// other two, never multiplies zero by infinity: its inverse is so large a number that one float's distance is far beyond
// all that matters.
//
// Triangles: sheared along the ray's dominant axis (Woop, Benthin & Wald: Watertight Ray/Triangle Intersection, JCGT 2(1),
// 2013) a triangle is hit where the three areas about the origin have one sign. A bound of their rounding errors, with the
// part that depends on the ray alone computed once, says which signs are sure: wide_triangles-inl.h.
class WideRay {
public:
    HWY_INLINE WideRay(const Ray& ray, const WideNodes& tree, double last, std::uint32_t number_it_leaves)
        : start(ray.range.min), leaving(number_it_leaves) {
        PerAxis axis;
        for (std::size_t i = 0; i < 4; i += axis_lanes) axis.set(ray, tree, i, *this);
        tame = start >= 0 && (axis.tame & 7) == 7 && !tree.is_far;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t upper = 3 * (axis.backward >> i & 1);
            near_row[i] = wide * (i + upper);
            far_row[i] = wide * (i + 3 - upper);
        }
        end_by(last);
        set_shear(axis);
    }

    // Whether floats will do: no coordinate beyond 2^39, directions between 2^-60 and 2^40 or zero, no negative t. Then nothing
    // overflows: areas are below 2^84, volumes below 2^126.
    bool tame;

    std::size_t near_row[3], far_row[3];  // of each axis, among a node's floats
    float near_origin[4], far_origin[4];  // moved outward
    float near_inverse[4], far_inverse[4];
    float start, end = std::numeric_limits<float>::max();

    std::size_t axes[3];                // the two the triangles are sheared in, and the dominant one
    float origin[3], direction[3];      // along those
    float shear[2];                     // direction along the first two, by that along the dominant one
    // How wrong an area may be: constant + r (linear + quadratic r), r the largest sheared coordinate of the triangle.
    float error_constant, error_linear;
    static constexpr float error_quadratic = 4 * unit * spare;
    std::uint32_t leaving;  // the number of the triangle that the ray leaves

    // Nothing beyond t matters any more. Rounded up (two roundings), and finite: a box met at infinity only is not met.
    HWY_INLINE void end_by(double t) {
        constexpr float most = std::numeric_limits<float>::max();
        if (t < end) end = t > -most ? static_cast<float>(t + 2 * unit * std::abs(t)) : -most;
    }

private:
    static constexpr float flattest = 0x1p-60f, steepest = 0x1p40f;
    static constexpr hn::CappedTag<float, 4> axis_tag{};
    static constexpr std::size_t axis_lanes = hn::MaxLanes(axis_tag);

    // What is the same for each axis; the fourth float means nothing (a ray has something there to be read).
    struct PerAxis {
        float origin[4], direction[4], steep[4], reach[4];  // reach: at least how far any corner is from the origin
        std::uint32_t tame = 0, backward = 0;               // a bit for each

        HWY_INLINE void set(const Ray& ray, const WideNodes& tree, std::size_t i, WideRay& to) {
            const auto number = [](float x) HWY_ATTR { return hn::Set(axis_tag, x); };
            const auto store = [&](hn::Vec<hn::CappedTag<float, 4>> x, float* at) HWY_ATTR { hn::StoreU(x, axis_tag, at + i); };
            const auto o = hn::LoadU(axis_tag, &ray.origin.x + i), d = hn::LoadU(axis_tag, &ray.direction.x + i), s = hn::Abs(d);
            store(o, origin);
            store(d, direction);
            store(s, steep);
            const auto zero = hn::Eq(d, number(0));
            const auto straight = hn::And(hn::Ge(s, number(flattest)), hn::Le(s, number(steepest)));
            tame |= bits(axis_tag, hn::And(hn::Le(hn::Abs(o), number(WideNodes::farthest)), hn::Or(zero, straight))) << i;

            const auto inverse = hn::IfThenElse(zero, number(0x1p126f), hn::Div(number(1), d));
            backward |= bits(axis_tag, hn::Lt(inverse, number(0))) << i;
            // One float's distance, or 2^-100 about zero, which no product with an inverse loses.
            const auto step = hn::Max(hn::Mul(hn::Abs(o), number(2 * unit)), number(0x1p-100f));
            const auto outward = hn::CopySignToAbs(step, inverse);
            store(hn::Add(o, outward), to.near_origin);
            store(hn::Sub(o, outward), to.far_origin);
            store(inverse, to.near_inverse);
            store(hn::Mul(inverse, number(1 + 12 * unit)), to.far_inverse);
            store(hn::Max(hn::Abs(hn::Sub(hn::LoadU(axis_tag, tree.least_corner.data() + i), o)),
                          hn::Abs(hn::Sub(hn::LoadU(axis_tag, tree.largest_corner.data() + i), o))), reach);
        }
    };

    HWY_INLINE void set_shear(const PerAxis& of) {
        const float x = of.steep[0], y = of.steep[1], z = of.steep[2];
        const std::size_t dominant = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        const std::size_t first = dominant == 2 ? 0 : dominant + 1, second = 3 - dominant - first;
        const std::size_t in_turn[] = {first, second, dominant};
        for (std::size_t i = 0; i < 3; ++i) {
            axes[i] = in_turn[i];
            origin[i] = of.origin[in_turn[i]];
            direction[i] = of.direction[in_turn[i]];
        }
        shear[0] = direction[0] * near_inverse[dominant];
        shear[1] = direction[1] * near_inverse[dominant];

        // x' = (a_x - o_x) - s (a_z - o_z): one rounding of the first term, four of the second (s has two), one of x'. Both
        // axes together.
        const float error = unit * spare * (2 * (of.reach[first] + of.reach[second]) +
                                            5 * (std::abs(shear[0]) + std::abs(shear[1])) * of.reach[dominant]) + 0x1p-139f;
        // U = c_x b_y - c_y b_x: each coordinate is wrong by up to e_x or e_y and no larger than r, each product and the
        // difference is rounded: 2 r (e_x + e_y) + 2 e_x e_y + 4 u r^2.
        error_linear = 2 * error * spare;
        error_constant = error * error * spare + 0x1p-140f;
    }
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
