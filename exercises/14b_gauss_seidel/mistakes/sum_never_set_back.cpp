// hint: sum_goes_on
// Adds what arrives to one sum for all patches.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    Color arrives(0);
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (j != i) arrives += system.form_factors.at(i, j) * radiosity[j];
        const Color own = system.reflectance[i] * system.form_factors.at(i, i);
        radiosity[i] = (system.emission[i] + system.reflectance[i] * arrives) / (1.0 - own);
    }
}
