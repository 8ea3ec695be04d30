// hint: cosine_behind
// One minus what gets through. The cosine behind is left squared.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sin(std::acos(cosine));
    if (sine >= 1) return 1;
    const double behind = 1 - sine * sine;
    const auto through = [](double one, double other) { return 4 * one * other / ((one + other) * (one + other)); };
    const double across = through(ior_before * cosine, ior_behind * behind);
    const double within = through(ior_behind * cosine, ior_before * behind);
    return 1 - (across + within) / 2;
}
