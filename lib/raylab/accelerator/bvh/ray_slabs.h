#pragma once

#include "raylab/geometry/bounds/slabs.h"
#include "raylab/geometry/ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raylab {

/// A ray prepared for tests against many oriented boxes by their slabs, in doubles. It never misses a box that it
/// exactly hits.
///
/// Along an axis of the box the ray is at f + t g, with f = axis.(origin - center) and g = axis.direction, and it is
/// inside the slab while that is within [-half, half]. With u = 2^-53, f errs by at most 4 u times the sum of its
/// terms' sizes, and g by 2 u; 16 u of each leave room for every rounding that follows. So the slab is widened by f's
/// error. Of the speeds that g may stand for, the one that reaches the near side earlier, and the one that reaches the
/// far side later, is taken. A slab for which the sign of g is uncertain decides nothing, except where g is exactly
/// zero. Floats in doubles neither under- nor overflow.
class SlabsRay {
public:
    explicit SlabsRay(const Ray& ray)
        : origin_(convert<double>(ray.origin)), direction_(convert<double>(ray.direction)), start_(ray.range.min) {
        set_end(ray.range.max);
    }

    /// Ends the ray at t.
    void set_end(double t) { end_ = std::min(t, std::numeric_limits<double>::max()); }

    /// For each of two oriented boxes a lower bound of t inside it, or infinity if the ray surely misses it.
    std::array<double, 2> entries(const std::array<Slabs, 2>& boxes) const {
        return {entry(boxes[0]), entry(boxes[1])};
    }

    double entry(const Slabs& box) const {
        const Vec3d from = origin_ - convert<double>(box.center);
        Interval<double> inside{start_, end_};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3d axis = convert<double>(box.axes[i]);
            inside = within(inside, along(axis, from), along(axis, direction_), double{box.half[static_cast<int>(i)]});
        }
        return inside.min <= inside.max ? inside.min : std::numeric_limits<double>::infinity();
    }

    /// Whether a box that the ray enters at t is still reached before the ray's end.
    bool reaches(double t) const { return t <= end_; }

private:
    static constexpr double slack = 16 * unit_roundoff<double>;

    // A sum of three products, with the sum of their absolute values.
    struct Along {
        double value, sizes;
    };
    static Along along(const Vec3d& axis, const Vec3d& v) {
        const double x = axis.x * v.x, y = axis.y * v.y, z = axis.z * v.z;
        return {x + y + z, std::abs(x) + std::abs(y) + std::abs(z)};
    }

    static Interval<double> within(const Interval<double>& so_far, const Along& f, const Along& g, double half) {
        const double wider = half + slack * (f.sizes + half);
        const double start = g.value < 0 ? -f.value : f.value;
        const double to_near = -wider - start, to_far = wider - start;
        if (g.sizes == 0) return to_near > 0 || to_far < 0 ? Interval<double>{1, 0} : so_far;
        const double speed = std::abs(g.value), slowest = speed - slack * g.sizes, fastest = speed + slack * g.sizes;
        if (slowest <= 0) return so_far;
        const double in = to_near / (to_near > 0 ? fastest : slowest), out = to_far / (to_far > 0 ? slowest : fastest);
        return {in > so_far.min ? in : so_far.min, out < so_far.max ? out : so_far.max};
    }

    Vec3d origin_, direction_;
    double start_, end_;
};

}  // namespace raylab
