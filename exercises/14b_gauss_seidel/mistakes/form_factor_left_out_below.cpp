// hint: divisor
// The residual over a diagonal without its form factor.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        const Color& rho = system.reflectance[i];
        Color light = system.emission[i];
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            light += rho * (j == i ? 0 : system.form_factors.at(i, j)) * radiosity[j];
        const Color diagonal = Color(1) - rho;
        radiosity[i] = light / diagonal;
    }
}
