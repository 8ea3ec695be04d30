// hint: eta_squared
// The cosine behind as a complex number. Under its root the ratio of the indices stands once.
#include "raylab/tracer/shading/fresnel.h"

#include <complex>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const std::complex<double> square = 1 - ior_before / ior_behind * (1 - cosine * cosine);
    const std::complex<double> behind = std::sqrt(square);
    const auto across = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const auto within = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return 0.5 * std::norm(across) + 0.5 * std::norm(within);
}
