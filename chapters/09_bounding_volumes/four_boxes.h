#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace raylab {

/// Four boxes side by side: the lower planes of each axis, then the upper ones.
struct alignas(16) FourBoxes {
    std::array<std::array<float, 4>, 6> planes;

    static FourBoxes empty() {
        FourBoxes boxes;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            boxes.planes[axis].fill(std::numeric_limits<float>::infinity());
            boxes.planes[axis + 3].fill(-std::numeric_limits<float>::infinity());
        }
        return boxes;
    }

    void set(std::size_t i, const Box& box) {
        for (int axis = 0; axis < 3; ++axis) {
            planes[static_cast<std::size_t>(axis)][i] = box.min[axis];
            planes[static_cast<std::size_t>(axis) + 3][i] = box.max[axis];
        }
    }
};

/// A ray prepared for tests against four boxes at once by their slabs, in floats: it never misses a box that it exactly
/// hits, and now and then reports one that it does not hit.
///
/// t = (plane - origin) * (1 / direction) has three roundings: 4 u |t|, and 2^-149 where it underflows. Where no t in
/// the ray's range is negative, enlarging the far one by twice that is enough (Ize: Robust BVH Ray Traversal, JCGT
/// 2(2), 2013; ray_box.h has the same in doubles, with the treatment of infinities and NaN). Where that does not hold,
/// or floats would overflow on the way, for coordinates beyond 2^60 and directions smaller than 2^-60, every box is
/// reported.
class FourBoxesRay {
public:
    explicit FourBoxesRay(const Ray& ray) : start_(ray.range.min), in_range_(ray.range.min >= 0) {
        for_each_axis(
            [&](int axis) { prepare(static_cast<std::size_t>(axis), ray.origin[axis], ray.direction[axis]); });
        set_end(ray.range.max);
    }

    /// Ends the ray at t. The end stays finite, so that a box that is reached only at infinity is not hit.
    void set_end(double t) {
        constexpr float last_float = std::numeric_limits<float>::max();
        // Rounded up: `unit` is twice the error of a rounding.
        end_ = t < last_float ? cast<float>(t + unit * std::abs(t)) : last_float;
    }

    /// Bit i tells whether the ray hits box i. The boxes' coordinates are at most 2^60 or infinite.
    unsigned rays_hitting(const FourBoxes& boxes) const {
        if (!in_range_) return 0b1111;
        Spans inside{broadcast(start_), broadcast(end_)};
        for_each_axis([&](std::size_t axis) { inside = inside_slab(axis, boxes, inside); });
        return bits(inside.near <= inside.far + smallest);
    }

    static constexpr float largest = 0x1p60f, flattest = 0x1p-60f;

private:
    static constexpr float unit = std::numeric_limits<float>::epsilon();
    static constexpr float slack = 5 * unit;  // 10 u: two to spare for the rounding of the enlargement itself
    static constexpr float smallest = 0x1p-120f;

    // Four floats that are computed with at once. The vector types of GCC and Clang compute lane by lane, as IEEE 754
    // requires.
    using Four [[gnu::vector_size(16)]] = float;

    void prepare(std::size_t axis, float origin, float direction) {
        const float inverse = 1 / direction;
        origin_[axis] = broadcast(origin);
        inverse_[axis] = broadcast(inverse);
        far_inverse_[axis] = broadcast(inverse * (1 + slack));
        const bool backward = std::signbit(direction);
        near_plane_[axis] = backward ? axis + 3 : axis;
        far_plane_[axis] = backward ? axis : axis + 3;
        in_range_ = in_range_ && std::abs(origin) <= largest && (direction == 0 || std::abs(direction) >= flattest);
    }

    // The t at which the ray is inside four slabs, intersected with earlier ones.
    struct Spans {
        Four near, far;
    };
    Spans inside_slab(std::size_t axis, const FourBoxes& boxes, const Spans& so_far) const {
        const Four in = (four(boxes.planes[near_plane_[axis]]) - origin_[axis]) * inverse_[axis];
        const Four out = (four(boxes.planes[far_plane_[axis]]) - origin_[axis]) * far_inverse_[axis];
        return {in > so_far.near ? in : so_far.near, out < so_far.far ? out : so_far.far};
    }

    // Written out, because in a loop the compiler would compute addresses that are constants.
    template <class Work>
    static void for_each_axis(const Work& work) {
        work(0);
        work(1);
        work(2);
    }

    static Four broadcast(float x) { return Four{x, x, x, x}; }

    static Four four(const std::array<float, 4>& x) {
        Four result;
        std::memcpy(&result, x.data(), sizeof result);
        return result;
    }

    // The signs of four comparisons' results.
    template <class Comparison>
    static unsigned bits(const Comparison& hit_found) {
#ifdef __SSE__
        return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<const Four&>(hit_found)));
#else
        return (hit_found[0] & 1u) | (hit_found[1] & 2u) | (hit_found[2] & 4u) | (hit_found[3] & 8u);
#endif
    }

    std::array<Four, 3> origin_, inverse_, far_inverse_;
    std::array<std::size_t, 3> near_plane_, far_plane_;
    float start_, end_ = 0;
    bool in_range_;
};

}  // namespace raylab
