#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace raylab {

/// Point number `i` of a sequence whose first N points, for every N, are spread evenly over the unit hypercube, moved
/// by `shifts`. (Roberts: The Unreasonable Effectiveness of Quasirandom Sequences, 2018: the sequence R_d.)
template <std::size_t d>
std::array<double, d> even_point(int i, const std::array<double, d>& shifts) {
    static_assert(d == 2 || d == 4);
    constexpr double root = d == 2 ? 1.32471795724474602596 : 1.16730397826141868426;  // of x^(d + 1) = x + 1
    std::array<double, d> point;
    double power = 1;
    for (std::size_t k = 0; k < d; ++k) {
        power /= root;
        const double x = shifts[k] + i * power;
        point[k] = x - std::floor(x);
    }
    return point;
}

}  // namespace raylab
