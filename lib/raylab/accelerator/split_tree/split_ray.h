#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/scalar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace raylab {

/// A ray prepared to be cut by axis-aligned planes, in floats or doubles: the t at which it crosses a plane lies surely
/// between two bounds.
///
/// t = (plane - origin) * (1 / direction) has three roundings, so it errs by less than 4 u |t|; as in ray_box.h the
/// bounds are 8 u |t| away by way of two inverses, which is right where no t is negative. Floats in doubles neither
/// under- nor overflow; in floats the ray has to satisfy the limits of RayInFloats and begin at its origin, and a t
/// that underflows is below `room`. Each span is wider by half the room at either end than the range it stands for,
/// which makes up for both: for underflow, and for negative t in doubles. A ray parallel to the plane has an infinite
/// inverse: t is infinite with the right sign, so that one child is visited; or, where the ray lies in the plane, 0 *
/// infinity = NaN, and every comparison with a bound must then fail, so that both children are visited.
template <Real T>
class SplitRay {
public:
    /// A range of t that surely holds the part of the ray that is inside a cell and still matters.
    struct Span {
        T begin, end;
        bool is_empty() const { return !(begin <= end); }
    };
    struct Crossing {
        T low, high;
    };

    explicit SplitRay(const Ray& ray) : room_(room_of(ray.range)) {
        whole_ = {ray.range.min - room_ / 2, std::min<T>(ray.range.max, std::numeric_limits<T>::max()) + room_ / 2};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const T inverse = 1 / T{ray.direction[i]};
            origin_[axis] = ray.origin[i];
            low_inverse_[axis] = inverse * (1 - slack);
            high_inverse_[axis] = inverse * (1 + slack);
            backward_[axis] = std::signbit(ray.direction[i]) ? 1 : 0;
        }
    }

    Crossing crossing(std::size_t axis, float plane) const {
        const T distance = plane - origin_[axis];
        return {distance * low_inverse_[axis], distance * high_inverse_[axis]};
    }

    /// The parts of a span in the half behind a plane, and in the half before it. The order of the arguments makes a
    /// NaN keep the span as it was.
    Span beyond(const Crossing& plane, const Span& span) const {
        return {std::max(span.begin, plane.low - room_), span.end};
    }
    Span before(const Crossing& plane, const Span& span) const {
        return {span.begin, std::min(span.end, plane.high + room_)};
    }

    /// The half that the ray comes from, 0 for the one below the plane. It does not depend on the origin, because the
    /// part behind the origin has negative t.
    std::uint32_t nearer_half(std::size_t axis) const { return backward_[axis]; }

    /// The range of t in which the ray may be inside a box.
    Span inside(const Box& box) const {
        Span span = whole_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const bool backward = backward_[axis] != 0;
            span = beyond(crossing(axis, backward ? box.max[i] : box.min[i]), span);
            span = before(crossing(axis, backward ? box.min[i] : box.max[i]), span);
        }
        return span;
    }

private:
    static constexpr T slack = 8 * unit_roundoff<T>;

    static T room_of(const Interval<float>& range) {
        if constexpr (std::same_as<T, float>) return 0x1p-100f;
        return std::max<T>(0, -8 * slack * range.min);
    }

    T room_;
    Span whole_;
    std::array<T, 3> origin_, low_inverse_, high_inverse_;
    std::array<std::uint32_t, 3> backward_;  // 1 where the direction is negative
};

}  // namespace raylab
