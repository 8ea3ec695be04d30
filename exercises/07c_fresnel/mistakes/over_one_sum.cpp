// hint: denominators
// Adds both squares up over one sum, which is that of the first amplitude.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double ratio = ior_before / ior_behind, left = 1 - ratio * ratio * (1 - cosine * cosine);
    if (left <= 0) return 1;
    const double behind = std::sqrt(left);
    const auto squared = [](double x) { return x * x; };
    const double differences = squared(ratio * cosine - behind) + squared(cosine - ratio * behind);
    return differences / (2 * squared(ratio * cosine + behind));
}
