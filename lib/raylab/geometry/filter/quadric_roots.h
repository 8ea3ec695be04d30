#pragma once

#include "raylab/geometry/filter/carried_ray.h"
#include "raylab/geometry/filter/sphere_filter.h"
#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/predicate/quadric_intersection.h"
#include "raylab/number/scalar.h"

#include <cmath>

// F(t) = a t^2 + 2 b t + c in plain doubles, with a > 0 and two zeros, and bounds of their errors.

namespace raylab::quadric_filter {

// What a product of origins, directions and a shape's own numbers errs by, over the product of their lengths. At rest
// each coordinate carries one rounding, and fewer than 120 come together (number/estimate.h). Of what is carried back,
// origin and direction are two factors each at most: where they are off by a part of their lengths, the product is off
// by four such parts, and by less than as much again for their products of each other and for roundings.
inline constexpr double relative_at_rest = 0x1p-46, relative_carried = 8 * CarriedRay::off;

// A quotient whose divisor is known to one part in 2^26 and better: what is divided by its worst case adds less than
// this.
inline constexpr double outward = 1 + 2 * t_accuracy;

// The error bounds of F's coefficients along a ray; of b the square of its bound.
struct ErrorBounds {
    double a, squared_b, c, discriminant;
};

inline bool begins_outside(const AlongRay<double>& f, const ErrorBounds& error_bound) { return f.c > error_bound.c; }

// The ray begins outside and goes away, or its line passes by: where a > 0.
inline bool surely_misses(const AlongRay<double>& f, const ErrorBounds& error_bound) {
    const bool goes_away = f.b > 0 && f.b * f.b > 4 * error_bound.squared_b;
    return (begins_outside(f, error_bound) && goes_away) || f.discriminant < -error_bound.discriminant;
}

using sphere_filter::Approximate;

inline bool surely_before(const Approximate& a, const Approximate& b) { return a.t + a.error < b.t - b.error; }

// Where F is zero. `relative` is the error of a product of the numbers from which F was made, and 2^-46 at least.
struct Roots {
    const AlongRay<double>& f;
    const ErrorBounds& error_bound;
    double relative;
    double root = std::sqrt(f.discriminant), size_of_q = std::abs(f.b) + root;
    double q_error = (error_bound.discriminant / root + std::sqrt(error_bound.squared_b)) / size_of_q +
                     4 * unit_roundoff<double>;  // relative

    bool are_well_known() const { return q_error < t_accuracy && error_bound.a < t_accuracy * f.a; }

    // One of the two forms of a root cancels.
    Approximate first() const { return f.b > 0 ? negative(by_a()) : by_q(); }
    Approximate last() const { return f.b > 0 ? negative(by_q()) : by_a(); }

private:
    static Approximate negative(const Approximate& root) { return {-root.t, root.error}; }
    Approximate by_q() const {
        const double t = f.c / size_of_q;
        return {t, (std::abs(t) * (q_error + relative) + error_bound.c / size_of_q) * outward};
    }
    Approximate by_a() const {
        const double t = size_of_q / f.a;
        return {t, t * (q_error + relative + error_bound.a / f.a) * outward};
    }
};

}  // namespace raylab::quadric_filter
