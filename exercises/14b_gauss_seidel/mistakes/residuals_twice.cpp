// hint: two_sweeps
// Adds what is missing in each equation, and then goes round once more, for the patches that had old values in theirs.
// theirs.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    const std::size_t patches = system.patches();
    for (std::size_t step = 0; step < 2 * patches; ++step) {
        const std::size_t i = step % patches;
        Color arriving(0);
        for (std::size_t j = 0; j < patches; ++j) arriving += system.form_factors.at(i, j) * radiosity[j];
        const Color& rho = system.reflectance[i];
        const Color missing = system.emission[i] + rho * arriving - radiosity[i];
        radiosity[i] += missing / (1.0 - rho * system.form_factors.at(i, i));
    }
}
