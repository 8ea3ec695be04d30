// hint: relaxed
// A little more than the whole residual is added.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    constexpr double more = 1.2;
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color residual = system.emission[i] - radiosity[i];
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            residual += system.reflectance[i] * (system.form_factors.at(i, j) * radiosity[j]);
        radiosity[i] += more * residual / (1.0 - system.form_factors.at(i, i) * system.reflectance[i]);
    }
}
