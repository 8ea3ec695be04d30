// hint: sine_before
// Works with one ratio of the indices. It multiplies the cosine, as if Snell's law spoke of cosines.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double ratio = ior_before / ior_behind, bent = ratio * cosine;
    const double left = 1 - bent * bent;
    if (left <= 0) return 1;
    const double behind = std::sqrt(left);
    const auto share = [](double one, double other) { return std::pow((one - other) / (one + other), 2); };
    return 0.5 * share(ratio * cosine, behind) + 0.5 * share(cosine, ratio * behind);
}
