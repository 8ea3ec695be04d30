// hint: own_reflectance
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const Color& rho = system.reflectance[i];
        Color others(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (j != i) others += system.form_factors.at(i, j) * radiosity[j];
        radiosity[i] = (system.emission[i] + rho * others) / (1.0 - system.form_factors.at(i, i));
    }
}
