// hint: total_reflection
// or: not_a_number
// Cook and Torrance's form takes its root of whatever comes out, also of what is negative.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double n = ior_behind / ior_before, c = cosine;
    const double g = std::sqrt(n * n - 1 + c * c);
    const double s = (g - c) / (g + c), ratio = (c * (g + c) - 1) / (c * (g - c) + 1);
    return 0.5 * s * s * (1 + ratio * ratio);
}
