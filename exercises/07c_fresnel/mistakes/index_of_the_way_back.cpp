// hint: indices
// Cook and Torrance's form knows one number of the two media, their ratio, and this is that of the way back.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double n = ior_before / ior_behind, square = n * n - 1 + cosine * cosine;
    if (square <= 0) return 1;
    const double g = std::sqrt(square), c = cosine;
    const double s = (g - c) / (g + c), ratio = (c * (g + c) - 1) / (c * (g - c) + 1);
    return 0.5 * s * s * (1 + ratio * ratio);
}
