// hint: no_refraction
// The same cosine on both sides.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    if (ior_before / ior_behind * std::sqrt(1 - cosine * cosine) >= 1) return 1;
    const double behind = cosine;
    const double s = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const double p = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return (s * s + p * p) / 2;
}
