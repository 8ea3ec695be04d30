// hint: emission_reflected
// Takes the emission for a part of what arrives.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color arriving = system.emission[i];
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (i != j) arriving += radiosity[j] * system.form_factors.at(i, j);
        radiosity[i] = arriving * system.reflectance[i];
        radiosity[i] /= Color(1) - system.reflectance[i] * system.form_factors.at(i, i);
    }
}
