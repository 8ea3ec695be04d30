#pragma once

#include "raylab/geometry/filter/sphere_filter.h"
#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/predicate/quadric_intersection.h"
#include "raylab/number/scalar.h"

#include <cmath>

// F(t) = a t^2 + 2 b t + c in plain doubles, with a > 0 and two zeros, and bounds of their errors.

namespace raylab::quadric_filter {

// A quotient whose divisor is known to one part in 2^26 and better: what is divided by its worst case adds less than
// this.
inline constexpr double outward = 1 + 2 * t_accuracy;

// The error bounds of F's coefficients along a ray; of b the square of its bound.
struct ErrorBounds {
    double a, squared_b, c, discriminant;
};

using sphere_filter::Approximate;

inline bool surely_before(const Approximate& a, const Approximate& b) { return a.t + a.error < b.t - b.error; }

// Where F is zero. `relative` is the error of a product of the numbers from which F was made, and 2^-46 at least.
struct Roots {
    const AlongRay<double>& f;
    const ErrorBounds& error_bound;
    double relative;
    double surd = std::sqrt(f.discriminant), size_of_q = std::abs(f.b) + surd;
    double q_error = (error_bound.discriminant / surd + std::sqrt(error_bound.squared_b)) / size_of_q +
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
