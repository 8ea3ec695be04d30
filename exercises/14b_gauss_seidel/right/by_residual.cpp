// What is missing in a patch's equation is added, over what adding changes.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        Color arriving(0);
        for (std::size_t j = 0; j < system.patches(); ++j) arriving += system.form_factors.at(i, j) * radiosity[j];
        const Color& rho = system.reflectance[i];
        const Color missing = system.emission[i] + rho * arriving - radiosity[i];
        radiosity[i] += missing / (1.0 - rho * system.form_factors.at(i, i));
    }
}
