// hint: own_patch_left_out
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color value = system.emission[i];
        for (std::size_t j = 0; j < i; ++j)
            value += system.reflectance[i] * radiosity[j] * system.form_factors.at(i, j);
        for (std::size_t j = i + 1; j < radiosity.size(); ++j)
            value += system.reflectance[i] * radiosity[j] * system.form_factors.at(i, j);
        radiosity[i] = value;
    }
}
