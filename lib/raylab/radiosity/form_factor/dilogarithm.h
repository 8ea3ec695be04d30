#pragma once

#include <complex>

namespace raylab {

/// Euler's dilogarithm, the sum of z^n / n^2 over n > 0 and its continuation beyond the unit circle, in the whole plane
/// but for a cut along the real axis from 1 to infinity; on the cut the sign of the imaginary part, +0 or -0, chooses
/// the side. The error is some 1e-16 of the larger of 1 and the value. (Lewin, Polylogarithms and Associated Functions,
/// 1981.)
std::complex<double> dilogarithm(std::complex<double> z);

}  // namespace raylab
