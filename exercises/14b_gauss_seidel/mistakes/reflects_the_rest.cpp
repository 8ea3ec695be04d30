// hint: reflectance
// The share that a patch keeps.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        Color sum(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (j != i) sum += system.form_factors.at(i, j) * radiosity[j];
        const Color rho = system.reflectance[i];
        const Color solved = (system.emission[i] + (1.0 - rho) * sum) / (1.0 - rho * system.form_factors.at(i, i));
        radiosity[i] = solved;
    }
}
