// hint: row_made_whole
// The weights of a row are made to add up to 1.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    const std::size_t n = system.patches();
    for (std::size_t i = 0; i < n; ++i) {
        Color arrives(0);
        double whole = 0;
        for (std::size_t j = 0; j < n; ++j) {
            if (j == i) continue;
            arrives += system.form_factors.at(i, j) * radiosity[j];
            whole += system.form_factors.at(i, j);
        }
        const Color kept = 1.0 - system.reflectance[i] * system.form_factors.at(i, i);
        radiosity[i] = (system.emission[i] + system.reflectance[i] * arrives / whole) / kept;
    }
}
