// hint: own_equation
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color b(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (i != j) b += system.form_factors.at(i, j) * radiosity[j];
        radiosity[i] = (system.emission[i] + system.reflectance[i] * b) *
                       (1.0 - system.reflectance[i] * system.form_factors.at(i, i));
    }
}
