// hint: emission_for_radiosity
// or: only_those_before
// Takes the patches that the sweep has not reached yet as if they had what they emit.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        Color others(0);
        for (std::size_t j = 0; j < i; ++j) others += system.form_factors.at(i, j) * radiosity[j];
        for (std::size_t j = i + 1; j < system.patches(); ++j)
            others += system.form_factors.at(i, j) * system.emission[j];
        const Color& rho = system.reflectance[i];
        radiosity[i] = (system.emission[i] + rho * others) / (1.0 - rho * system.form_factors.at(i, i));
    }
}
