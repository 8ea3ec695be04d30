// hint: pi
// Takes rho / pi, a surface's scattering per steradian, for its reflectance.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include <numbers>

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        const Color brdf = system.reflectance[i] * std::numbers::inv_pi;
        Color sum(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (j != i) sum += radiosity[j] * system.form_factors.at(i, j);
        radiosity[i] = (system.emission[i] + brdf * sum) / (1.0 - brdf * system.form_factors.at(i, i));
    }
}
