#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>
#include <numbers>

namespace raylab {

/// The direction of the hemisphere around z of two numbers in [0, 1), with density (n + 1) / (2 pi) cos^n. 1 - cos is
/// computed without its difference, so a lobe of exponent 10^9 has all its digits.
inline Vec3d power_cosine_direction(double exponent, double u, double v) {
    const double below = -std::expm1(std::log1p(-u) / (exponent + 1));  // 1 - z, where z = (1 - u)^(1 / (n + 1))
    const double across = std::sqrt(below * (2 - below)), turn = 2 * std::numbers::pi * v;
    return {across * std::cos(turn), across * std::sin(turn), 1 - below};
}

/// Its density per steradian in a direction with this cosine; zero behind.
inline double power_cosine_pdf(double exponent, double cosine) {
    return cosine > 0 ? (exponent + 1) / (2 * std::numbers::pi) * std::pow(cosine, exponent) : 0;
}

}  // namespace raylab
