// hint: not_stored
// Solves for a copy of each element.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    std::size_t i = 0;
    for (Color value : radiosity) {
        Color sum = -system.form_factors.at(i, i) * value;
        for (std::size_t j = 0; j < radiosity.size(); ++j) sum += system.form_factors.at(i, j) * radiosity[j];
        value = (system.emission[i] + system.reflectance[i] * sum) /
                (1.0 - system.reflectance[i] * system.form_factors.at(i, i));
        ++i;
    }
}
