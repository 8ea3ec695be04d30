// hint: not_squared
// The amplitudes as complex numbers. Of each the size is taken, and not the size's square.
#include "raylab/tracer/shading/fresnel.h"

#include <complex>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double eta = ior_before / ior_behind;
    const std::complex<double> behind = std::sqrt(std::complex<double>(1 - eta * eta * (1 - cosine * cosine)));
    const auto size = [&](double at_cosine, double at_behind) {
        const std::complex<double> one = at_cosine * cosine, other = at_behind * behind;
        return std::abs((one - other) / (one + other));
    };
    return (size(ior_before, ior_behind) + size(ior_behind, ior_before)) / 2;
}
