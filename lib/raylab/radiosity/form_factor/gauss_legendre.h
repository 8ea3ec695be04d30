#pragma once

#include <span>

namespace raylab {

/// A place in [0, 1] and its weight; the weights of a rule sum to 1.
struct GaussPoint {
    double place, weight;
};

constexpr int most_gauss_points = 16;

/// The Gauss-Legendre rule of 1 to most_gauss_points points, exact for polynomials of degree 2 points - 1. If the
/// nearest singularity lies at distance k from the interval's middle, in units of half its length, the relative error
/// of a smooth integrand is about (k + sqrt(k^2 - 1))^(-2 points).
std::span<const GaussPoint> gauss_legendre(int points);

}  // namespace raylab
