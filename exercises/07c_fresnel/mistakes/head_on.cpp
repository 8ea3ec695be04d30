// hint: angle_forgotten
// The share of light that comes along the normal.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    if (ior_before / ior_behind * std::sqrt(1 - cosine * cosine) >= 1) return 1;
    const double r = (ior_before - ior_behind) / (ior_before + ior_behind);
    return r * r;
}
