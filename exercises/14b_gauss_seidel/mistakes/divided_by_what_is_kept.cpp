// hint: divisor
// By 1 - rho, the share that a patch keeps.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        Color sum(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (j != i) sum += system.form_factors.at(i, j) * radiosity[j];
        radiosity[i] = (system.emission[i] + system.reflectance[i] * sum) / (1.0 - system.reflectance[i]);
    }
}
