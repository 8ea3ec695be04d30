// Fresnel's own form: sines and tangents of the two angles.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double a = std::acos(cosine), sine = ior_before / ior_behind * std::sin(a);
    if (sine >= 1) return 1;
    if (a < 1e-7) return std::pow((ior_before - ior_behind) / (ior_before + ior_behind), 2);
    const double b = std::asin(sine);
    const double s = std::sin(a - b) / std::sin(a + b), p = std::tan(a - b) / std::tan(a + b);
    return 0.5 * (s * s + p * p);
}
