// hint: denominators
// Each difference over the other one's sum.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sqrt((1 - cosine) * (1 + cosine));
    if (!(sine < 1)) return 1;
    const double behind = std::sqrt((1 - sine) * (1 + sine));
    const double a = ior_before * cosine, b = ior_behind * behind, c = ior_behind * cosine, d = ior_before * behind;
    const double s = (a - b) / (c + d), p = (c - d) / (a + b);
    return 0.5 * s * s + 0.5 * p * p;
}
