// hint: not_stored
// Sweeps through a copy, which nobody sees.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    Radiosities now(radiosity.begin(), radiosity.end());
    for (std::size_t i = 0; i < now.size(); ++i) {
        Color arriving(0);
        for (std::size_t j = 0; j < now.size(); ++j)
            if (j != i) arriving += system.form_factors.at(i, j) * now[j];
        now[i] = (system.emission[i] + system.reflectance[i] * arriving) /
                 (1.0 - system.reflectance[i] * system.form_factors.at(i, i));
    }
}
