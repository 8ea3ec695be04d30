// hint: total_is_all
// The absolute value under the root: along the surface that gives 1 all the same.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double eta = ior_before / ior_behind;
    const double behind = std::sqrt(std::abs(1 - eta * eta * (1 - cosine * cosine)));
    const double s = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const double p = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return (s * s + p * p) / 2;
}
