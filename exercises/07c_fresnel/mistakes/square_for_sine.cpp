// hint: eta_squared
// The ratio of the indices, not squared.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double square = ior_before / ior_behind * (1 - cosine * cosine);
    if (square >= 1) return 1;
    const double behind = std::sqrt(1 - square);
    const double s = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const double p = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return (s * s + p * p) / 2;
}
