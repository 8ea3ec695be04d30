// hint: area
// Turns radiosity into power, and gathers it by F_ij, which is a share of the other patch's view.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color power(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j) {
            if (i == j) continue;
            const Color sent = system.area[j] * radiosity[j];
            power += system.form_factors.at(i, j) * sent;
        }
        const Color arriving = power / system.area[i];
        radiosity[i] = (system.emission[i] + system.reflectance[i] * arriving) /
                       (1.0 - system.reflectance[i] * system.form_factors.at(i, i));
    }
}
