// hint: no_refraction
// One minus what gets through, of light that goes straight on: the products are with one cosine.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 1;
    const double a = ior_before * cosine, b = ior_behind * cosine;
    const double through_across = 4 * a * b / ((a + b) * (a + b));
    const double through_within = 4 * b * a / ((b + a) * (b + a));
    return 1 - (through_across + through_within) / 2;
}
