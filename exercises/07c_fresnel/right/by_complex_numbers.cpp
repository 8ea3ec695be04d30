// The cosine behind as a complex number: total reflection needs no question.
#include "raylab/tracer/shading/fresnel.h"

#include <complex>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double eta = ior_before / ior_behind;
    const std::complex<double> behind = std::sqrt(std::complex<double>(1 - eta * eta * (1 - cosine * cosine)));
    const auto s = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const auto p = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return 0.5 * (std::norm(s) + std::norm(p));
}
