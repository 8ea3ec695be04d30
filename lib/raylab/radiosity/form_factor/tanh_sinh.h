#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace raylab {

/// A place of the tanh-sinh rule: its distance from the nearer end of [0, 1], and its weight.
struct TanhSinhPoint {
    double from_end, weight;
};

/// The places of step 2^-level that no coarser step has, in the lower half of [0, 1]; the upper half mirrors them. The
/// middle is not among them. Levels 0 to most_tanh_sinh_levels - 1.
constexpr int most_tanh_sinh_levels = 8;
const std::vector<TanhSinhPoint>& tanh_sinh_points(int level);

/// The integral of f from 0 to length, by the tanh-sinh rule (Takahasi and Mori, "Double exponential formulas for
/// numerical integration", 1974): its places crowd towards both ends, so that logarithms, roots and kinks there do no
/// harm. The step is halved until the sum changes by at most `tolerance`. Each halving doubles the number of right
/// digits, so the error is far below the tolerance. Weak spot: a singularity inside; the caller splits there.
template <class Function>
double tanh_sinh_integral(const Function& f, double length, double tolerance) {
    constexpr double middle_weight = std::numbers::pi / 4;
    double sum = middle_weight * f(0.5 * length), integral = 0;
    for (int level = 0; level < most_tanh_sinh_levels; ++level) {
        for (const auto& [from_end, weight] : tanh_sinh_points(level))
            sum += weight * (f(from_end * length) + f(length - from_end * length));
        const double before = integral;
        integral = std::ldexp(sum * length, -level);
        if (level > 2 && std::abs(integral - before) <= tolerance) break;
    }
    return integral;
}

}  // namespace raylab
