// By the column: A_j F_ji / A_i is F_ij.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        Color power(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (j != i) power += system.area[j] * radiosity[j] * system.form_factors.at(j, i);
        const Color& rho = system.reflectance[i];
        const Color leaving = system.emission[i] * system.area[i] + rho * power;
        radiosity[i] = leaving / (system.area[i] * (1.0 - rho * system.form_factors.at(i, i)));
    }
}
