// hint: lights_reflect
// Takes a patch that emits for a light alone, whose radiosity is known already.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        if (system.emission[i] != Color(0)) {
            radiosity[i] = system.emission[i];
            continue;
        }
        Color arrives(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (j != i) arrives += system.form_factors.at(i, j) * radiosity[j];
        const Color rho = system.reflectance[i];
        radiosity[i] = rho * arrives / (1.0 - rho * system.form_factors.at(i, i));
    }
}
