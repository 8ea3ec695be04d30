#pragma once

#include "raylab/geometry/box.h"
#include "raylab/geometry/ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace raylab {

/// A ray prepared to be cut by axis-aligned planes, in doubles: where it crosses one lies surely between two bounds.
///
/// t = (plane - origin) * (1 / direction) has three roundings, and floats in doubles neither under- nor overflow, so it
/// errs by less than 4 u |t|; as in ray_box.h the bounds are 8 u |t| away by way of two inverses, and `behind_` makes
/// up for negative t where they matter. A ray parallel to the plane has an infinite inverse: t is infinite on the right
/// side, so that one child is visited; or, where the ray lies in the plane, 0 * infinity = NaN, and every comparison
/// with a bound must then fail and leave both children to be visited.
class SplitRay {
public:
    /// What is known to hold all that matters of a ray inside a cell.
    struct Span {
        double begin, end;
        bool is_empty() const { return !(begin <= end); }
    };
    struct Crossing {
        double low, high;
    };

    explicit SplitRay(const Ray& ray)
        : span_{ray.range.min, std::min<double>(ray.range.max, std::numeric_limits<double>::max())},
          behind_(std::max(0.0, -4 * slack * span_.begin)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const double inverse = 1 / static_cast<double>(ray.direction[i]);
            origin_[axis] = ray.origin[i];
            low_inverse_[axis] = inverse * (1 - slack);
            high_inverse_[axis] = inverse * (1 + slack);
            backward_[axis] = std::signbit(ray.direction[i]) ? ~0u : 0u;
        }
    }

    Crossing crossing(std::size_t axis, float plane) const {
        const double distance = plane - origin_[axis];
        return {distance * low_inverse_[axis] - behind_, distance * high_inverse_[axis] + behind_};
    }

    /// What is below and above an axis' planes, that which the ray comes from first; where the origin is does not
    /// matter, for behind it are the negative t. (By bits: no memory, and no jump that is hard to foresee.)
    struct InOrder {
        std::uint32_t near, far;
    };
    InOrder in_order(std::size_t axis, std::uint32_t below, std::uint32_t above) const {
        const std::uint32_t exchanged = (below ^ above) & backward_[axis];
        return {below ^ exchanged, above ^ exchanged};
    }

    /// Where the ray may be inside a box.
    Span inside(const Box& box) const {
        Span span = span_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const auto [in, out] =
                backward_[axis] ? std::pair{box.max[i], box.min[i]} : std::pair{box.min[i], box.max[i]};
            span.begin = std::max(span.begin, crossing(axis, in).low);  // in this order NaN leaves what was
            span.end = std::min(span.end, crossing(axis, out).high);
        }
        return span;
    }

private:
    static constexpr double slack = 8 * unit_roundoff<double>;

    Span span_;
    double behind_;
    std::array<double, 3> origin_, low_inverse_, high_inverse_;
    std::array<std::uint32_t, 3> backward_;  // all bits set: the direction is negative
};

}  // namespace raylab
