// hint: total_is_all
// The share begins with 0, and only where something gets through is it set.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    double share = 0;
    const double before = std::acos(cosine), sine = ior_before / ior_behind * std::sin(before);
    if (before < 1e-7) {
        share = std::pow((ior_before - ior_behind) / (ior_before + ior_behind), 2);
    } else if (sine < 1) {
        const double behind = std::asin(sine);
        share += std::pow(std::sin(before - behind) / std::sin(before + behind), 2) / 2;
        share += std::pow(std::tan(before - behind) / std::tan(before + behind), 2) / 2;
    }
    return share;
}
