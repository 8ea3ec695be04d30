// hint: mean
// or: factor
// Cook and Torrance's form without any angle, and without the half in front of it.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double n = ior_behind / ior_before, square = n * n - 1 + cosine * cosine;
    if (square <= 0) return 1;
    const double g = std::sqrt(square), c = cosine;
    const double across = (g - c) / (g + c), ratio = (c * (g + c) - 1) / (c * (g - c) + 1);
    return across * across * (1 + ratio * ratio);
}
