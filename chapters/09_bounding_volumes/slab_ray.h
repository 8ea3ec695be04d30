#pragma once

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/next_float.h"

#include <algorithm>
#include <cmath>

// The slab test as it is usually written, in its variants, most of which lose rays. README (4) and (6).

namespace raylab::volumes {

/// How the ends of the ray's part in a slab are ordered and intersected; a NaN (0 * infinity) has a different effect in
/// each way.
enum class Keep { fmin_fmax, min_max, ordered };

/// How t is computed with the inverse of the direction: (plane - origin) * inverse, or plane * inverse - origin *
/// inverse.
enum class Form { difference, products };

/// Whether the far ends are enlarged by 2 ulp (Ize, Robust BVH Ray Traversal, JCGT 2(2), 2013).
enum class Pad { none, two_ulp };

/// A ray prepared in this way. It can replace the lab's own in a tree.
template <Real T, Keep keep, Form form = Form::difference, Pad pad = Pad::none>
class SlabRay {
public:
    explicit SlabRay(const Ray& ray) : origin_(convert<T>(ray.origin)), start_(ray.range.min) {
        for (int axis = 0; axis < 3; ++axis) inverse_[axis] = 1 / cast<T>(ray.direction[axis]);
        set_end(ray.range.max);
    }

    void set_end(double t) { end_ = std::min(rounded_up(t), std::numeric_limits<float>::max()); }
    bool reaches(double t) const { return t <= end_; }

    /// The t at which the ray enters; infinite where it misses.
    double entry(const Box& box) const {
        Interval<T> inside{start_, end_};
        for (int axis = 0; axis < 3; ++axis) {
            const T at_low = at(axis, box.min[axis]), at_high = at(axis, box.max[axis]);
            inside = kept(inside, axis, at_low, at_high);
        }
        return inside.min <= inside.max ? inside.min : std::numeric_limits<double>::infinity();
    }
    std::array<double, 2> entries(const BoxTree::Planes& planes) const {
        return {entry(box_of(planes, 0)), entry(box_of(planes, 1))};
    }

private:
    T at(int axis, float plane) const {
        if constexpr (form == Form::products)
            return plane * inverse_[axis] - origin_[axis] * inverse_[axis];
        else
            return (plane - origin_[axis]) * inverse_[axis];
    }

    Interval<T> kept(const Interval<T>& so_far, int axis, T at_low, T at_high) const {
        constexpr T later = pad == Pad::none ? T(1) : 1 + 2 * std::numeric_limits<T>::epsilon();
        if constexpr (keep == Keep::fmin_fmax) {
            return {std::fmax(so_far.min, std::fmin(at_low, at_high)),
                    std::fmin(so_far.max, std::fmax(at_low, at_high) * later)};
        } else if constexpr (keep == Keep::min_max) {
            return {std::max(so_far.min, std::min(at_low, at_high)),
                    std::min(so_far.max, std::max(at_low, at_high) * later)};
        } else {
            const bool backward = std::signbit(inverse_[axis]);
            const T in = backward ? at_high : at_low, out = (backward ? at_low : at_high) * later;
            return {in > so_far.min ? in : so_far.min, out < so_far.max ? out : so_far.max};
        }
    }

    Vec3<T> origin_, inverse_;
    T start_, end_;
};

using FminFmax = SlabRay<float, Keep::fmin_fmax>;
using MinMax = SlabRay<float, Keep::min_max>;
using Ordered = SlabRay<float, Keep::ordered>;
using Products = SlabRay<float, Keep::ordered, Form::products>;
using Padded = SlabRay<float, Keep::ordered, Form::difference, Pad::two_ulp>;
using OrderedInDoubles = SlabRay<double, Keep::ordered>;

}  // namespace raylab::volumes
