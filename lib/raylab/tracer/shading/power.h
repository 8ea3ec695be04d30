#pragma once

#include <cmath>

namespace raylab {

/// x^n for x >= 0. A whole n, as most materials have, is split into powers of two, which takes half of std::pow's time
/// and errs by less than n units of 2^-53.
inline double power(double x, double n) {
    constexpr double largest = 1024;
    if (!(n >= 0 && n <= largest && n == static_cast<int>(n))) return std::pow(x, n);
    double result = 1;
    for (auto left = static_cast<unsigned>(n); left != 0; left >>= 1, x *= x)
        if ((left & 1) != 0) result *= x;
    return result;
}

}  // namespace raylab
