// hint: schlick
// Schlick's, by the angle before the surface always.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double n = (ior_before - ior_behind) / (ior_before + ior_behind), f0 = n * n;
    if (ior_before / ior_behind * std::sqrt(1 - cosine * cosine) >= 1) return 1;
    return f0 + (1 - f0) * std::pow(1 - cosine, 5);
}
