// hint: two_sweeps
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include <cmath>

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    double change = 1;
    while (change > 1e-12) {
        change = 0;
        for (std::size_t i = 0; i < radiosity.size(); ++i) {
            const Color& rho = system.reflectance[i];
            Color others(0);
            for (std::size_t j = 0; j < radiosity.size(); ++j)
                if (j != i) others += system.form_factors.at(i, j) * radiosity[j];
            const Color now = (system.emission[i] + rho * others) / (1.0 - rho * system.form_factors.at(i, i));
            change = std::max(change, glm::length(now - radiosity[i]));
            radiosity[i] = now;
        }
    }
}
