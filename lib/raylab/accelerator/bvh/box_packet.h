#pragma once

#include "raylab/accelerator/bvh/ray_box.h"

#include <algorithm>
#include <array>
#include <span>

namespace raylab {

/// Tests several rays at once against a box: either none of them hits it, or all of them do, or each has to be tested.
/// It does the arithmetic of BoxRay's test on intervals that hold the numbers of all rays. Rounding is monotonic, so a
/// bound computed from the ends of the intervals bounds what each ray computes, its rounding errors included; no error
/// bound is needed here. (Boulos, Wald, Shirley: Geometric and arithmetic culling methods for entire ray packets, TR
/// 2006.)
class BoxPacket {
public:
    /// The rays must have the same sign of direction along each axis, no zero component, and ranges that begin at t >=
    /// 0: fits() tells whether they do.
    explicit BoxPacket(std::span<const BoxRay> rays);

    static bool fits(std::span<const Ray> rays);

    enum class RaysHitting { none, some, all };

    /// The answer for one of two boxes. None of the rays reaches farther than t = end.
    RaysHitting rays_hitting(const BoxTree::Planes& planes, std::size_t side, double end) const;

private:
    struct Ends {
        double low, high;

        void unite(double x) {
            low = std::min(low, x);
            high = std::max(high, x);
        }
    };
    struct Axis {
        std::size_t near_plane, far_plane;
        Ends origin, near_inverse, far_inverse;
    };

    // The interval of (plane - origin) * inverse: from the smallest to the largest of the four products of the ends.
    static Ends t(double plane, const Ends& origin, const Ends& inverse) {
        const double smallest = plane - origin.high, largest = plane - origin.low;
        const double a = smallest * inverse.low, b = smallest * inverse.high, c = largest * inverse.low,
                     d = largest * inverse.high;
        return {std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d))};
    }

    std::array<Axis, 3> axes_;
    Ends start_;
};

inline BoxPacket::BoxPacket(std::span<const BoxRay> rays) : start_{rays[0].start_, rays[0].start_} {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto first = [&](const std::array<double, 3>& of_axes) { return Ends{of_axes[axis], of_axes[axis]}; };
        const BoxRay& ray = rays[0];
        Axis& all = axes_[axis];
        all = {ray.near_plane_[axis], ray.far_plane_[axis], first(ray.origin_), first(ray.near_inverse_),
               first(ray.far_inverse_)};
        for (const BoxRay& other : rays) {
            all.origin.unite(other.origin_[axis]);
            all.near_inverse.unite(other.near_inverse_[axis]);
            all.far_inverse.unite(other.far_inverse_[axis]);
        }
    }
    for (const BoxRay& other : rays) start_.unite(other.start_);
}

inline bool BoxPacket::fits(std::span<const Ray> rays) {
    for (const Ray& ray : rays) {
        if (!(ray.range.min >= 0)) return false;
        for (int axis = 0; axis < 3; ++axis) {
            const float d = ray.direction[axis];
            if (d == 0 || !std::isfinite(d) || std::signbit(d) != std::signbit(rays[0].direction[axis])) return false;
        }
    }
    return true;
}

inline BoxPacket::RaysHitting BoxPacket::rays_hitting(const BoxTree::Planes& planes, std::size_t side,
                                                      double end) const {
    Ends near = start_, far{end, end};  // some rays may end before `end`; counting them to `all` only costs tests
    for (const Axis& axis : axes_) {
        const Ends in = t(planes[axis.near_plane][side], axis.origin, axis.near_inverse);
        const Ends out = t(planes[axis.far_plane][side], axis.origin, axis.far_inverse);
        near = {std::max(near.low, in.low), std::max(near.high, in.high)};
        far = {std::min(far.low, out.low), std::min(far.high, out.high)};
    }
    if (near.low > far.high) return RaysHitting::none;
    return near.high <= far.low ? RaysHitting::all : RaysHitting::some;
}

}  // namespace raylab
