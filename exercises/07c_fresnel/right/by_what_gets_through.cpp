// One minus what gets through.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 1;
    const double behind = std::sqrt(1 - sine * sine);
    const double a = ior_before * cosine, b = ior_behind * behind, c = ior_behind * cosine, d = ior_before * behind;
    const double through = 2 * a * b / ((a + b) * (a + b)) + 2 * c * d / ((c + d) * (c + d));
    return 1 - through;
}
