// hint: cosine_behind
// The root of the square that the sine is, and not of what is left of 1.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double eta = ior_before / ior_behind;
    const double square = eta * eta * (1 - cosine * cosine);
    if (square >= 1) return 1;
    const double behind = std::sqrt(square);
    const double across = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const double within = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return (across * across + within * within) / 2;
}
