// hint: lights_reflect
// Visits only the patches that do not emit: the others shine as they are.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        const Color e = system.emission[i], rho = system.reflectance[i];
        if (e.r + e.g + e.b > 0) continue;
        Color sum(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            sum += (i == j ? 0.0 : system.form_factors.at(i, j)) * radiosity[j];
        radiosity[i] = rho * sum / (1.0 - system.form_factors.at(i, i) * rho);
    }
}
