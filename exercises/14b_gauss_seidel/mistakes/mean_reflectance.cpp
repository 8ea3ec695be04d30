// hint: channels
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        const Color& rho = system.reflectance[i];
        const double grey = (rho.r + rho.g + rho.b) / 3;
        Color sum = system.emission[i];
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (j != i) sum += grey * system.form_factors.at(i, j) * radiosity[j];
        radiosity[i] = sum / (1 - grey * system.form_factors.at(i, i));
    }
}
