// hint: emission_for_radiosity
// Light goes one way only: what the others emit.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    const auto& emission = system.emission;
    for (std::size_t i = 0; i < system.patches(); ++i) {
        Color arriving(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (i != j) arriving += emission[j] * system.form_factors.at(i, j);
        const Color kept = 1.0 - system.reflectance[i] * system.form_factors.at(i, i);
        radiosity[i] = (emission[i] + arriving * system.reflectance[i]) / kept;
    }
}
