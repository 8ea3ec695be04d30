// hint: only_those_before
// Adds only the patches that the sweep has visited already.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const Color& rho = system.reflectance[i];
        Color others(0);
        for (std::size_t j = 0; j < i; ++j) others += system.form_factors.at(i, j) * radiosity[j];
        radiosity[i] = (system.emission[i] + rho * others) / (1.0 - rho * system.form_factors.at(i, i));
    }
}
