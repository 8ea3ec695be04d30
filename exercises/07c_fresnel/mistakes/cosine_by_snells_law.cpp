// hint: sine_before
// The cosine stands in Snell's law.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * cosine;
    if (sine >= 1) return 1;
    const double behind = std::sqrt(1 - sine * sine);
    const double s = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const double p = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return (s * s + p * p) / 2;
}
