// hint: one_polarization
// Fresnel's form with the two angles, of which only the one with tangents is written down.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double before = std::acos(cosine), sine = ior_before / ior_behind * std::sin(before);
    if (sine >= 1) return 1;
    if (before < 1e-7) return std::pow((ior_before - ior_behind) / (ior_before + ior_behind), 2);
    const double behind = std::asin(sine);
    const double amplitude = std::tan(before - behind) / std::tan(before + behind);
    return amplitude * amplitude;
}
