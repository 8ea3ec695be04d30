// hint: mean
// The half stands before the first of the two shares alone.
#include "raylab/tracer/shading/fresnel.h"

#include <algorithm>
#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 1;
    const double behind = std::sqrt(1 - sine * sine);
    const double a = ior_before * cosine, b = ior_behind * behind, c = ior_behind * cosine, d = ior_before * behind;
    const double across = (a - b) / (a + b), within = (c - d) / (c + d);
    return within * within / 2 + across * across;
}
