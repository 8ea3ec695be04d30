// hint: cosine_behind
// 1 - sin^2 is the cosine's square.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double eta = ior_before / ior_behind;
    const double square = eta * eta * (1 - cosine * cosine);
    if (square >= 1) return 1;
    const double behind = 1 - square;
    const double across = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const double within = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return (across * across + within * within) / 2;
}
