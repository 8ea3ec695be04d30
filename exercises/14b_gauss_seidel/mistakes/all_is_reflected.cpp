// hint: reflectance_forgotten
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        Color others(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (j != i) others += system.form_factors.at(i, j) * radiosity[j];
        radiosity[i] = (system.emission[i] + others) / (1.0 - system.reflectance[i] * system.form_factors.at(i, i));
    }
}
