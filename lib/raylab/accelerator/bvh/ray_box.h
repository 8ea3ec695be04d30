#pragma once

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/geometry/ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace raylab {

/// A ray prepared for tests against many boxes by their slabs, in doubles. It never misses a box that it exactly hits.
///
/// t = (plane - origin) * (1 / direction) has three roundings, and floats in doubles neither under- nor overflow, so it
/// errs by less than 4 u |t|. By way of the inverse, which is computed once for each ray, this much is subtracted from
/// each near plane's t and added to each far plane's. That is right in front of the origin; behind it, it is right only
/// if the ray's range begins there, and `behind_` makes up for that. Where the direction is zero, its inverse is
/// infinite: t is infinite with the right sign, or 0 * infinity = NaN where the origin lies in a slab's plane, which
/// counts as inside; so each comparison keeps its earlier value when the new one is NaN. (Williams et al., JGT 10(1),
/// 2005; Ize, JCGT 2(2), 2013.)
class BoxRay {
public:
    explicit BoxRay(const Ray& ray) : start_(ray.range.min), behind_(std::max(0.0, -4 * slack * start_)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const double inverse = 1 / static_cast<double>(ray.direction[i]);
            origin_[axis] = ray.origin[i];
            near_inverse_[axis] = inverse * (1 - slack);
            far_inverse_[axis] = inverse * (1 + slack);
            const bool backward = std::signbit(ray.direction[i]);
            near_plane_[axis] = backward ? axis + 3 : axis;
            far_plane_[axis] = backward ? axis : axis + 3;
        }
        set_end(ray.range.max);
    }

    /// Ends the ray at t. The end stays finite, so that a box that is reached only at infinity is not hit.
    void set_end(double t) { end_ = std::min(t, std::numeric_limits<double>::max()); }

    double end() const { return end_; }

    /// For each of two boxes a lower bound of t inside it, or infinity if the ray surely misses it.
    std::array<double, 2> entries(const BoxTree::Planes& planes) const {
        return entries_between([&](std::size_t plane) { return pair(planes[plane]); });
    }

    /// Whether a box that the ray enters at t is still reached before the ray's end.
    bool reaches(double t) const { return t <= end_; }

protected:
    // Two doubles computed with at once. The vector types of GCC and Clang compute lane by lane, as IEEE 754 requires.
    using Pair [[gnu::vector_size(16)]] = double;

    static Pair pair(const std::array<float, 2>& x) { return Pair{x[0], x[1]}; }

    // The same for boxes whose planes, numbered as in BoxTree::Planes, `pair_at` tells.
    template <class PairAt>
    [[gnu::always_inline]] std::array<double, 2> entries_between(const PairAt& pair_at) const {
        Pair near = {start_, start_}, far = {end_, end_};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Pair in = (pair_at(near_plane_[axis]) - origin_[axis]) * near_inverse_[axis];
            const Pair out = (pair_at(far_plane_[axis]) - origin_[axis]) * far_inverse_[axis];
            near = in > near ? in : near;
            far = out < far ? out : far;
        }
        near -= behind_;
        const Pair entry = near <= far + behind_ ? near : Pair{} + std::numeric_limits<double>::infinity();
        return {entry[0], entry[1]};
    }

private:
    friend class BoxPacket;  // does the same arithmetic with intervals
    // Twice the 4 u of the bound, for the rounding of the inverse and some to spare.
    static constexpr double slack = 8 * unit_roundoff<double>;

    std::array<double, 3> origin_, near_inverse_, far_inverse_;
    std::array<std::size_t, 3> near_plane_, far_plane_;
    double start_, end_;
    double behind_;  // the error of t where it is negative and inside the ray's range
};

}  // namespace raylab
