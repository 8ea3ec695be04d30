// hint: one_critical_angle
// Glass keeps what arrives at more than 41.8 degrees; other media do not.
#include "raylab/tracer/shading/fresnel.h"

#include <algorithm>
#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = std::sqrt(1 - cosine * cosine);
    if (ior_before > ior_behind && sine >= 1 / 1.5) return 1;
    const double behind = std::sqrt(1 - std::pow(ior_before / ior_behind * sine, 2));
    const double a = ior_before * cosine, b = ior_behind * behind, c = ior_behind * cosine, d = ior_before * behind;
    return (std::pow((a - b) / (a + b), 2) + std::pow((c - d) / (c + d), 2)) / 2;
}
