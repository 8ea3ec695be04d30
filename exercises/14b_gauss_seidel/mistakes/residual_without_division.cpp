// hint: own_patch
// Adds what is missing, without dividing by what adding changes.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color arriving(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j) arriving += system.form_factors.at(i, j) * radiosity[j];
        const Color residual = system.emission[i] + system.reflectance[i] * arriving - radiosity[i];
        radiosity[i] += residual;
    }
}
