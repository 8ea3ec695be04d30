// hint: not_squared
// Goes through both polarisations, and adds up their amplitudes as if these were shares.
#include "raylab/tracer/shading/fresnel.h"

#include <array>
#include <cmath>
#include <utility>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sqrt((1 - cosine) * (1 + cosine));
    if (sine >= 1) return 1;
    const double behind = std::sqrt((1 - sine) * (1 + sine));
    const std::array products{std::pair{ior_before * cosine, ior_behind * behind},
                              std::pair{ior_behind * cosine, ior_before * behind}};
    double sum = 0;
    for (const auto& [one, other] : products) sum += (one - other) / (one + other);
    return std::abs(sum) / 2;
}
