// hint: schlick
// Schlick's approximation.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double n = (ior_before - ior_behind) / (ior_before + ior_behind), f0 = n * n;
    const double sine = ior_before / ior_behind * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 1;
    const double c = ior_before > ior_behind ? std::sqrt(1 - sine * sine) : cosine;
    return f0 + (1 - f0) * std::pow(1 - c, 5);
}
