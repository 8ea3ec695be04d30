// hint: denominators
// Both differences over the first sum.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double eta = ior_before / ior_behind;
    const double square = eta * eta * (1 - cosine * cosine);
    if (square >= 1) return 1;
    const double behind = std::sqrt(1 - square);
    const double sum = ior_before * cosine + ior_behind * behind;
    const double across = (ior_before * cosine - ior_behind * behind) / sum;
    const double within = (ior_behind * cosine - ior_before * behind) / sum;
    return (across * across + within * within) / 2;
}
