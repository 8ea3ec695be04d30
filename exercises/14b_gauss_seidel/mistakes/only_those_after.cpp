// hint: only_those_before
// Leaves out the patches whose new radiosity is known.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color arriving(0);
        for (std::size_t j = i + 1; j < radiosity.size(); ++j) arriving += system.form_factors.at(i, j) * radiosity[j];
        const Color& rho = system.reflectance[i];
        radiosity[i] = (system.emission[i] + rho * arriving) / (1.0 - rho * system.form_factors.at(i, i));
    }
}
